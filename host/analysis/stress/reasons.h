// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Reasons for allowed errors that several stress cases share.
#pragma once

namespace dynrt::host::stress::reasons {

/// Of the thesis's test (5.2).
inline constexpr char kCracks[] =
    "neighbouring triangles map a ray by matrices of their own and round apart: a crack at the "
    "edge";
inline constexpr char kSharedEdge[] =
    "an edge belongs to both its triangles where both maps round to it";

inline constexpr char kSteps[] =
    "a step of the numbers is 2^-16 of the distance from the origin; vertices, camera and the "
    "translations of matrices are no finer";
inline constexpr char kFarEye[] = "a step of a direction is a thirteenth of a radius there";
inline constexpr char kGrazing[] =
    "a step of the direction moves the point that is met by 2^-17 over the angle's sine";

inline constexpr char kNoZero[] =
    "there is no zero: the distance to the surface itself is the smallest number, and where its "
    "sign comes out positive it is a hit";

}  // namespace dynrt::host::stress::reasons
