// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace dynrt::host {

/// Throws UserError in a program that was built without CGAL and Embree (DYNRT_PROGRAM_ONLY). For
/// commands that need the truth, before they read a scene.
void require_truth();

}  // namespace dynrt::host
