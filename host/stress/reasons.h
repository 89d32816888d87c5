// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Why things may go wrong, where that is the same in several stress cases.
#pragma once

namespace dynrt::host::stress::reasons {

/// Of the thesis's test (5.2).
inline constexpr char kCracks[] =
    "neighbouring triangles map a ray by matrices of their own and round apart: a crack at the "
    "edge";
inline constexpr char kSharedEdge[] =
    "an edge belongs to both its triangles where both maps round to it";

inline constexpr char kNoZero[] =
    "there is no zero: the distance to the surface itself is the smallest number, and where its "
    "sign comes out positive it is a hit";

}  // namespace dynrt::host::stress::reasons
