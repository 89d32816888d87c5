// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The choices of a configuration that are neither numbers nor yes or no
// (hls/configs/configurations/keys.py).
#pragma once

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

/// The way a ray is clipped to the box of an object that it enters (thesis 4.2).
enum class ObjectBox : std::uint8_t {
  kNodes,  ///< by six clipping nodes of the object's tree
  kUnit,   ///< by a unit of its own, as the object's matrix takes the box to a cube
  kWorld,  ///< by a unit that tests the box in the world before the object is entered
};

/// The way the distance of a node's plane is found: offset over direction (thesis 6.1.1).
enum class Divider : std::uint8_t {
  kQuotient,          ///< by a division in every slice, rounded once
  kReciprocal,        ///< by the direction's reciprocal, taken once for each ray and level
  kThreeReciprocals,  ///< the same, all three components of a ray in a clock
};

/// The origins of a packet's rays in the traversal.
enum class Origins : std::uint8_t {
  kEach,    ///< every slice has its ray's, and subtracts it from the plane
  kCommon,  ///< one for all, subtracted once for the packet: reflected rays have none
};

/// The way a packet's camera rays are made.
enum class CameraSource : std::uint8_t {
  kTransformation,  ///< as pre-primary rays that the transformation maps (thesis 6.2.1)
  kOwnUnit,         ///< beside it, by units/camera_rays.h
};

/// The addition of a transformation's products.
enum class Sums : std::uint8_t {
  kRounded,  ///< every product and every sum is rounded
  kFused,    ///< the sum is rounded once (hls/dot_circuit.h)
};

/// The way a leaf of a tree is known (units/packet.h has the pointers).
enum class Leaves : std::uint8_t {
  kNodes,     ///< by a node of its own, which has the address of its list
  kPointers,  ///< by the pointer of the node above, which is to the list
};

/// The rays of a packet that enter an object or meet a triangle (thesis 4.3.2: all).
enum class RaysSent : std::uint8_t {
  kTraced,  ///< all that are traced: an item of any leaf is met once
  kActive,  ///< those that are in the leaf: an item is met again by others in a later leaf
};

/// The FIFOs of traversal events and list jobs that hold every packet (units/core.h).
enum class PacketFifos : std::uint8_t {
  kAll,  ///< each, so that no writer waits
  kOne,  ///< those of node_fetch and others that it takes to keep each loop moving
};

/// The stored form of a triangle (thesis 5.1).
enum class TriangleMatrix : std::uint8_t {
  kNormalConsistent,  ///< 12 numbers: the plane's normal is a row
  kMemoryEfficient,   ///< 9 numbers, and two bits that say which column is (1, 1, 1)
};

/// The test of a ray against a triangle.
enum class TriangleTest : std::uint8_t {
  kUnitTriangle,  ///< the triangle's matrix takes the ray to the unit triangle (thesis 5.2)
  kWatertight,    ///< the ray's shear takes the corners to the plane; an exact rule for the edges
  kWatertightCommon,  ///< the same where a packet's rays have one origin, in integers
};
constexpr bool is_watertight(TriangleTest test) { return test != TriangleTest::kUnitTriangle; }

/// The unit objects that are intersected (thesis 5.2).
struct Primitives {
  bool triangle = false;
  bool sphere = false;  ///< hence every ellipsoid
  bool rectangle = false;

  constexpr unsigned count() const { return unsigned{triangle} + sphere + rectangle; }
  friend constexpr bool operator==(const Primitives&, const Primitives&) = default;
};

}  // namespace dynrt
