// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/bounds.h"
#include "host/analysis/stress/reasons.h"

namespace dynrt::host::stress {

namespace {

constexpr char kBorder[] =
    "an edge belongs to one of its two sides, so half of the rays exactly through the border of a "
    "surface pass it";
constexpr char kLevel[] =
    "all rays at thin triangles: a height that cancels to zero becomes the smallest number above "
    "zero, so the two long edges of a triangle thinner than a step fall on one side";
constexpr char kRange[] =
    "corners and differences saturate, as the matrix of the thesis's test does at other sizes";

constexpr Bound kBounds[] = {
    {"slivers/fan_1e4", {.lost = 1}, kBorder},
    {"sizes/millionth_on_axis", {.wrong = 65}, kBorder},
    {"sizes/millionth_off_axis", {.wrong = 266}, reasons::kSteps},
    {"far/scene_1e2", {.distance = 1.7e-3}, reasons::kSteps},
    {"far/scene_1e3", {.invented = 1, .wrong = 3, .distance = 1.6e-2}, reasons::kSteps},
    {"far/scene_1e4", {.lost = 2, .invented = 8, .wrong = 45, .distance = 4.3e-2}, reasons::kSteps},
    {"far/scene_1e5",
     {.lost = 16, .invented = 27, .wrong = 204, .distance = 9.4e-2},
     reasons::kSteps},
    {"far/scene_1e6", {.lost = 268}, reasons::kSteps},
    {"far/sphere_148376", {.lost = 268}, reasons::kSteps},
    {"far/camera_1e4", {.lost = 9, .invented = 7}, reasons::kFarEye},
    {"planes/in_box_plane",
     {.wrong = 7},
     "the format has no zero: a height of zero differs by 2^-62 between ray and floor, so the two "
     "meet somewhere"},
    {"grazing/slanting_hundredth_degree", {.distance = 3.4e-2}, reasons::kGrazing},
    {"ends/on_surface_outward", {.invented = 42}, reasons::kNoZero},
    {"ends/on_surface_inward", {.wrong = 42}, reasons::kNoZero},
    {"cameras/on_vertex", {}, ""},
    {"degenerate/coincident_instances",
     {.lost = 4},
     "a ray that touches the outline, in each of four frames"},
    {"degenerate/nearly_zero_area", {.wrong = 930}, kLevel},
    {"degenerate/almost_no_area", {.wrong = 930}, kLevel},
    {"exponents/largest_scene", {}, ""},
    {"exponents/smallest_scene", {.distance = 0.88}, kRange},
    {"exponents/distance_too_large", {.lost = 5, .distance = 0.5}, kRange},
    {"exponents/triangle_too_small", {.lost = 1}, kRange},
};

}  // namespace

std::span<const Bound> watertight_bounds() { return kBounds; }

}  // namespace dynrt::host::stress
