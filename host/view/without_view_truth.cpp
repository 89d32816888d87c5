// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// For the build of the program alone, which has neither CGAL nor Embree.
#include "host/view/view_truth.h"

namespace dynrt::host {

std::unique_ptr<ViewTruth> ViewTruth::of(const Scene& /*scene*/) { return nullptr; }

}  // namespace dynrt::host
