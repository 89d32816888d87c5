// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt report truth: the primitives that the primary rays of a scene really hit
// (host/analysis/truth), how often doubles did not suffice to decide, and where and why Embree
// finds another one.
#pragma once

#include "host/app/work_report.h"

namespace dynrt::host {

/// Throws UserError in a program that was built without CGAL and Embree (DYNRT_PROGRAM_ONLY),
/// before a scene is read.
void require_truth();
WorkReport truth_report(const Prepared& prepared);

}  // namespace dynrt::host
