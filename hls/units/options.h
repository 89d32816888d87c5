// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The choices of a configuration that are neither numbers nor yes or no
// (hls/configs/configurations/keys.py).
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace dynrt {

/// The beginning of the names that units, channels and RAMs of one of several pipelines have.
inline std::string pipeline_prefix(unsigned pipeline) {
  return "p" + std::to_string(pipeline) + "_";
}

/// The core's way to the memory that holds the scene.
enum class MemoryPath : std::uint8_t {
  kBanks,  ///< three banks of SRAM (thesis chapter 7)
  kPort,   ///< any memory behind one port (units/memory_port.h)
};

/// The treatment of a packet whose rays enter the children in different orders (thesis 3.1.3).
enum class Crossing : std::uint8_t {
  kNone,      ///< the first ray's order is taken: right for rays of one origin
  kSplit,     ///< packets are split by the signs of their rays' directions
  kRemember,  ///< the child that is left out at first is remembered
};

/// The core's datapath.
enum class Datapath : std::uint8_t {
  /// As the thesis has it: all rays of a packet meet what any of them meets (4.3.2), slices divide
  /// (6.1.1), the transformation makes camera rays (6.2.1), every product and every sum is rounded,
  /// and leaves are nodes.
  kThesis,
  kFast,  ///< a later one, smaller and quicker (units/packet.h says what is different)
};

/// The origins of a packet's rays in the traversal.
enum class Origins : std::uint8_t {
  kEach,    ///< every slice has its ray's, and subtracts it from the plane
  kCommon,  ///< one for all, subtracted once for the packet: reflected rays have none
};

/// Whether rays that miss the box of an object in the world do not enter the object
/// (units/world_box.h). Boxes are stored as they lie from the point where all rays start.
constexpr bool tests_world_box(Origins origins, unsigned levels) {
  return origins == Origins::kCommon && levels == 2;
}
template <class C>
inline constexpr bool kTestsWorldBox = tests_world_box(C::kOrigins, C::kLevels);

/// Bytes of a line of the second level of cache: a line of the first lies in it, 8 bytes for each
/// node, and it takes at least a beat of the port.
constexpr unsigned second_line_bytes(unsigned line_nodes, unsigned port_bytes) {
  return std::max({16u, 8 * line_nodes, port_bytes});
}

/// The stored form of a triangle (thesis 5.1).
enum class TriangleMatrix : std::uint8_t {
  kNormalConsistent,  ///< 12 numbers: the plane's normal is a row
  kMemoryEfficient,   ///< 9 numbers, and two bits that say which column is (1, 1, 1)
};

/// The test of a ray against a triangle.
enum class TriangleTest : std::uint8_t {
  kUnitTriangle,  ///< the triangle's matrix takes the ray to the unit triangle (thesis 5.2)
  /// An exact rule for the edges: a ray's shear takes the corners to the plane, or with the fast
  /// datapath, where a packet's rays have one origin, its plane map does, in integers.
  kWatertight,
};

/// The unit objects that are intersected (thesis 5.2).
struct Primitives {
  bool triangle = false;
  bool sphere = false;  ///< hence every ellipsoid
  bool rectangle = false;

  constexpr unsigned count() const { return unsigned{triangle} + sphere + rectangle; }
  friend constexpr bool operator==(const Primitives&, const Primitives&) = default;
};

}  // namespace dynrt
