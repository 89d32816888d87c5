// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages about scenes that cannot be laid out in the board's memory.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kTooMany[] =
    "scene '{}' needs {} {}, {} more than the {} that the board's memory holds; use fewer or "
    "smaller objects";
inline constexpr char kOutOfReach[] =
    "scene '{}' needs {} {}, {} more than the {} that the core reaches; take a configuration with "
    "more {} than {}";
inline constexpr char kNoPrimitive[] =
    "scene '{}' has {}, and configuration {} lacks the key for them; take a configuration whose "
    "key "
    "primitives lists them";
inline constexpr char kBeyondMargin[] =
    "object '{}'{}: small for the scene; rays that start many times its size away from it may pass "
    "it at an edge in a plane of its tree, though it is tested watertight";
inline constexpr char kColours[] =
    "scene '{}' has surfaces of the colours {:#08x} and {:#08x} (object '{}', 0xBBGGRR), and the "
    "core has one for all; take a configuration without one_colour";
inline constexpr char kOneObject[] =
    "scene '{}' has {} instances, and the core has trees of one level, for one object alone; take "
    "a configuration with levels 2";
inline constexpr char kNotAsItIs[] =
    "scene '{}': instance '{}' moves, turns or scales its object, and the core has trees of one "
    "level, for an object that lies in the world as it is; take a configuration with levels 2";
inline constexpr char kFlatTriangle[] =
    "object '{}', triangle {} has no area; its corners must not lie on one line";
inline constexpr char kTriangleRange[] =
    "object '{}', triangle {}: its matrix has the element {:g}, outside the core's numbers "
    "(-{:.5g} to {:.5g}); the triangle must be less thin or less small";
inline constexpr char kSphereRange[] =
    "object '{}', sphere {}: its matrix has the element {:g}, outside the core's numbers "
    "(-{:.5g} to {:.5g}); the sphere must be less small";
inline constexpr char kFlatInstance[] =
    "instance '{}' has a transform without an inverse; it must not flatten its object";
inline constexpr char kInstanceRange[] =
    "instance '{}': the inverse of its transform has the element {:g}, outside the core's numbers "
    "(-{:.5g} to {:.5g}); the transform must flatten its object less";
inline constexpr char kCameraRange[] =
    "the camera's matrix has the element {:g}, outside the core's numbers (-{:.5g} to {:.5g}); the "
    "camera must be closer";
inline constexpr char kLightRange[] =
    "light '{}' stands at {} = {:g}, outside the core's numbers (-{:.5g} to {:.5g}); it must be "
    "closer";

// A scene that is too far-flung and too fine at once: {far}, {fine}
inline constexpr char kNoScale[] =
    "scene '{}' fits the {} exponent bits of the core's numbers at no scale: {}, and {}; take a "
    "format with more of them, or make the two more alike";
inline constexpr char kReaches[] = "{} {} = {:g}";
inline constexpr char kSmallInstance[] = "instance '{}' is scaled down that far";
inline constexpr char kSmall[] = "{} {} of object '{}' has a matrix with the element {:g}";

}  // namespace dynrt::host::messages
