// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/bounds.h"
#include "host/analysis/stress/reasons.h"

namespace dynrt::host::stress {

namespace {

constexpr char kOutline[] = "a ray at the outline meets the triangle beside the nearest";

constexpr Bound kBounds[] = {
    {"far/scene_1e3", {.wrong = 7, .distance = 1.7e-2}, reasons::kSteps},
    {"far/scene_1e5",
     {.lost = 109, .invented = 51, .wrong = 151, .distance = 0.13},
     reasons::kSteps},
    {"far/scene_1e6", {.lost = 262, .invented = 10, .wrong = 6}, reasons::kSteps},
    {"far/sphere_148376", {.lost = 194, .invented = 41, .wrong = 74}, reasons::kSteps},
    {"ends/on_surface_inward", {.wrong = 84}, reasons::kNoZero},
    {"edges/vertices", {.lost = 16}, reasons::kCracks},
    {"edges/edges", {.lost = 29}, reasons::kCracks},
    {"edges/sphere_vertices", {.lost = 36}, reasons::kCracks},
    {"edges/sphere_vertices_at_256", {.lost = 56, .distance = 1.9e-3}, reasons::kCracks},
    {"edges/one_by_one", {.twice = 40}, reasons::kSharedEdge},
    {"instances/scale_1e-6", {.wrong = 1}, kOutline},
    {"instances/sheared", {.wrong = 1}, kOutline},
    {"exponents/distance_too_small",
     {.lost = 48, .distance = 128},
     "the distance saturates at 2^-63, and there the ray is far beyond the wall: no hit, or one at "
     "that distance"},
};

}  // namespace

std::span<const Bound> fast_bounds() { return kBounds; }

}  // namespace dynrt::host::stress
