// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The errors of the tree builders, and their notes about trees that had to be cut.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kNoTriangles[] =
    "object '{}' has no triangles; an object must have at least one";
inline constexpr char kCoordinate[] =
    "object '{}', triangle {}, vertex {}: {} = {:g} is outside the core's numbers; coordinates "
    "must lie within -{:.5g} and {:.5g}";
inline constexpr char kPrimitiveBox[] =
    "object '{}', primitive {}: its box reaches {} = {:g}, outside the core's numbers; coordinates "
    "must lie within -{:.5g} and {:.5g}";
inline constexpr char kNoInstances[] =
    "scene '{}' has no instances; a scene must have at least one";
inline constexpr char kInstanceBox[] =
    "instance '{}': its box reaches {} = {:g}, outside the core's numbers; coordinates must lie "
    "within -{:.5g} and {:.5g}";

// Notes, which are no errors
inline constexpr char kCut[] =
    "object '{}': its tree has only depth {}, to fit the board's {} tree nodes and {} list "
    "entries; {}; the whole tree fits if the triangles are fewer or smaller";
inline constexpr char kCutWork[] =
    "a ray across the object probably makes {:.1f} times the work of the whole tree";
inline constexpr char kCutTriangles[] =
    "a ray across the object probably meets {:.0f} nodes and {:.0f} triangles";

}  // namespace dynrt::host::messages
