// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// All primitives that a ray may hit, found by Embree's traversal over their boxes.
//
// Embree computes in floats, and the truth is exact. So Embree gets only boxes (user geometry), and
// it must miss no box that contains a hit. The scene is moved and scaled by a power of two such
// that it lies in the cube from -1 to 1; directions are scaled by a power of two such that their
// largest component is between 1 and 2; an origin outside the cube of half-width kStartCube is
// moved along the ray to it, so that no ray is longer than 2 kStartCube. Rounded to floats, an
// origin is off by 2^-24 in each coordinate and a direction by 2^-24 a length of 1, hence a hit by
// less than 2^-21; the earlier rounding of boxes and origins to doubles, at most kFarthest away
// (rays from farther away are tested by brute force), is less than 2^-28. Boxes are grown by
// kGrowth = 2^-16 and rounded outwards: nearly all of that is left for Embree's own traversal,
// whose slab distances are off by a few 2^-24 of a length of at most 4, and which runs in robust
// mode. A ray ends kSlack behind the closest hit so far and begins kSlack before `from`, so that by
// the same sum the box of a hit in between is entered before the one and left after the other.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "host/analysis/truth/truth.h"

namespace dynrt::host {

struct CandidateBox {
  glm::dvec3 low, high;
};

/// Gets each candidate and returns the largest t, in lengths of the ray's direction, up to which it
/// wants more; a value below the ray's `from` ends the search.
class CandidateVisitor {
 public:
  virtual ~CandidateVisitor() = default;
  virtual double visit(PrimitiveId id) = 0;
};

class CandidateTree {
 public:
  /// boxes[i] are those of instance i's primitives. They need not live on.
  explicit CandidateTree(const std::vector<std::vector<CandidateBox>>& boxes);
  ~CandidateTree();
  CandidateTree(const CandidateTree&) = delete;
  CandidateTree& operator=(const CandidateTree&) = delete;

  /// Visits each candidate at most once for a ray. Returns false, without a visit, if the ray
  /// begins too far away for the argument above.
  bool visit(const TruthRay& ray, CandidateVisitor& visitor) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace dynrt::host
