// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the tree builders refuse.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kNoTriangles[] =
    "object '{}' has no triangles to build a tree over; an object must have at least one";
inline constexpr char kCoordinate[] =
    "object '{}', triangle {}, vertex {}: {} = {:g} is outside the core's numbers; coordinates "
    "must lie within -{:.5g} and {:.5g}";
inline constexpr char kNoInstances[] =
    "scene '{}' has no instances to build a tree over; a scene must have at least one";
inline constexpr char kInstanceBox[] =
    "instance '{}': its box reaches {} = {:g}, outside the core's numbers; coordinates must lie "
    "within -{:.5g} and {:.5g}";

}  // namespace dynrt::host::messages
