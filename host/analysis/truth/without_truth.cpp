// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Stands for candidates.cpp, exact.cpp and embree_check.cpp in a program that is built alone
// (DYNRT_PROGRAM_ONLY), without CGAL and Embree. That program renders; its commands that need the
// truth say how to build them.
#include "host/analysis/truth/candidates.h"
#include "host/analysis/truth/embree_check.h"
#include "host/analysis/truth/exact.h"
#include "host/analysis/truth/require_truth.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

constexpr char kNoTruth[] =
    "this program was built by scripts/demo without CGAL and Embree, which find what a ray really "
    "hits; scripts/test --build-only installs both and builds the whole program";

}  // namespace

void require_truth() { refuse(kNoTruth); }

struct CandidateTree::State {};
CandidateTree::CandidateTree(const std::vector<std::vector<CandidateBox>>&) { refuse(kNoTruth); }
CandidateTree::~CandidateTree() = default;
bool CandidateTree::visit(const TruthRay&, CandidateVisitor&) const { refuse(kNoTruth); }

Crossing cross(const Line&, const FlatShape&, std::uint64_t&) { refuse(kNoTruth); }
int compare_t(const Line&, const FlatShape&, double) { refuse(kNoTruth); }
int compare_t(const Line&, const FlatShape&, const FlatShape&) { refuse(kNoTruth); }
std::optional<PlaneValues> plane_values(const Line&, const FlatShape&) { refuse(kNoTruth); }

EmbreeComparison compare_with_embree(const Truth&, std::span<const TruthRay>,
                                     std::span<const std::optional<TruthHit>>) {
  refuse(kNoTruth);
}

}  // namespace dynrt::host
