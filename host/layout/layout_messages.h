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
    "scene '{}' has {}, but configuration {} cannot hold them; take a configuration whose key "
    "primitives lists them";
inline constexpr char kAnotherCore[] =
    "scene '{}' is laid out for a core with {} {}, and configuration {} has {}; lay it out for the "
    "core that renders it";
inline constexpr char kBeyondMargin[] =
    "object '{}'{} is small for the scene: a ray that starts many times its size away may miss it "
    "at an edge that lies in a plane of its tree, although the watertight test would hit it";
inline constexpr char kColours[] =
    "scene '{}' has surfaces of the colours {:#08x} and {:#08x} (object '{}', 0xBBGGRR), but the "
    "core has one colour for all; take a configuration without one_colour";
inline constexpr char kOneObject[] =
    "scene '{}' has {} instances, but the core's trees have one level and hold one object; take a "
    "configuration with levels 2";
inline constexpr char kNotAsItIs[] =
    "scene '{}': instance '{}' moves, turns or scales its object, but the core's trees have one "
    "level and cannot move an object; take a configuration with levels 2";
inline constexpr char kFlatTriangle[] =
    "object '{}', triangle {} has no area; its corners must not lie on one line";
inline constexpr char kTriangleRange[] =
    "object '{}', triangle {}: its matrix has the element {:g}, outside the core's numbers "
    "(-{:.5g} to {:.5g}); make the triangle thicker or larger";
inline constexpr char kSphereRange[] =
    "object '{}', sphere {}: its matrix has the element {:g}, outside the core's numbers (-{:.5g} "
    "to {:.5g}); make the sphere larger";
inline constexpr char kFlatInstance[] =
    "instance '{}' has a transform without an inverse; the transform must not flatten its object";
inline constexpr char kInstanceRange[] =
    "instance '{}': the inverse of its transform has the element {:g}, outside the core's numbers "
    "(-{:.5g} to {:.5g}); let the transform flatten or shrink its object less";
inline constexpr char kCameraRange[] =
    "the camera's matrix has the element {:g}, outside the core's numbers (-{:.5g} to {:.5g}); "
    "move the camera closer to the scene";
inline constexpr char kLightRange[] =
    "light '{}' stands at {} = {:g}, outside the core's numbers (-{:.5g} to {:.5g}); move it "
    "closer to the scene";

// A scene that is too far-flung and too fine at once: {far}, {fine}
inline constexpr char kNoScale[] =
    "no scale fits scene '{}' into the {} exponent bits of the core's numbers: {}, and {}; take a "
    "format with more exponent bits, or make the two more alike in size";
inline constexpr char kReaches[] = "{} {} = {:g}";
inline constexpr char kSmallInstance[] = "instance '{}' is scaled down too far";
inline constexpr char kSmall[] = "{} {} of object '{}' has a matrix with the element {:g}";

}  // namespace dynrt::host::messages
