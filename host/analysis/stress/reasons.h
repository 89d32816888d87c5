// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Reasons for allowed errors that several stress cases share.
#pragma once

namespace dynrt::host::stress::reasons {

/// Of the thesis's test (5.2).
inline constexpr char kCracks[] =
    "neighbouring triangles map a ray by different matrices and round differently: a crack at the "
    "edge";
inline constexpr char kSharedEdge[] =
    "an edge belongs to both its triangles if both maps round to it";

inline constexpr char kSteps[] =
    "a step of the numbers is 2^-16 of the distance from the origin; vertices, the camera and the "
    "translations of matrices have no finer steps";
inline constexpr char kFarEye[] =
    "at that distance a step of a direction is a thirteenth of a radius";
inline constexpr char kGrazing[] =
    "a step of the direction moves the hit point by 2^-17 divided by the angle's sine";

inline constexpr char kNoZero[] =
    "the format has no zero: the distance to the surface itself is the smallest number, and the "
    "core reports a hit if its sign is positive";

}  // namespace dynrt::host::stress::reasons
