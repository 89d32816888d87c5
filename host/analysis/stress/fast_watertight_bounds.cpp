// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/bounds.h"
#include "host/analysis/stress/reasons.h"

namespace dynrt::host::stress {

namespace {

constexpr char kBlock[] =
    "a corner's components are cut off 2^-18 behind the largest of them, seen from the origin";
constexpr char kBlockGrazing[] =
    "a corner's components are cut off 2^-18 behind the largest of them, which moves the hit point "
    "by that divided by the angle's sine";
constexpr char kBorder[] =
    "an edge belongs to one of its two sides, so all of the rays exactly along the border of a "
    "surface may pass it";
constexpr char kThin[] =
    "all rays at thin triangles: thinner than a step, they may lie in front of the wall anywhere";

constexpr Bound kBounds[] = {
    {"slivers/disc", {.distance = 1.6e-3}, kBlockGrazing},
    {"sizes/millionth_on_axis", {.wrong = 128}, kBorder},
    {"sizes/millionth_off_axis", {.wrong = 511}, reasons::kSteps},
    {"far/scene_1e2", {.distance = 1.8e-3}, reasons::kSteps},
    {"far/camera_1e2", {.lost = 1}, "a ray at the outline"},
    {"far/camera_1e4", {.lost = 12, .invented = 9, .wrong = 1}, reasons::kFarEye},
    {"planes/in_splitting_plane",
     {.lost = 90},
     "the tree made by hand lists a triangle on one side of the plane alone, where the host lists "
     "it on both, and by its rounding the ray meets the triangle on the other side"},
    {"planes/in_box_plane", {.lost = 60}, kBorder},
    {"grazing/tenth_degree", {.distance = 3.4e-3}, kBlockGrazing},
    {"grazing/hundredth_degree", {.distance = 4.0e-2}, kBlockGrazing},
    {"grazing/thousandth_degree", {.distance = 0.43}, kBlockGrazing},
    {"grazing/slanting_half_degree", {.distance = 1.2e-3}, kBlockGrazing},
    {"grazing/slanting_tenth_degree", {.distance = 6.1e-3}, kBlockGrazing},
    {"grazing/slanting_hundredth_degree", {.distance = 6.5e-2}, kBlockGrazing},
    {"degenerate/nearly_zero_area", {.wrong = 961}, kThin},
    {"degenerate/almost_no_area", {.wrong = 961}, kThin},
    {"instances/sheared", {.lost = 1}, kBlock},
    {"instances/flat_1e-6", {.lost = 441}, kBlock},
    {"exponents/distance_too_large",
     {.lost = 49},
     "the core reports no hit whose distance is beyond its numbers"},
    {"exponents/distance_too_small",
     {.distance = 128},
     "the distance saturates at 2^-63, the smallest number"},
};

}  // namespace

std::span<const Bound> fast_watertight_bounds() { return kBounds; }

}  // namespace dynrt::host::stress
