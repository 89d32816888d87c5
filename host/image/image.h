// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene as it lies in the board's memory. What stands still is laid out once, from the bottom:
// the objects' trees, lists and triangle matrices (ObjectImage). What may move follows it and is
// made anew for every frame: the top-level tree, the instances' matrices, the camera's and the
// lights' (FrameImage). Its place is the same in every frame, and its size is known from the number
// of instances (top_level_room) and of lights.
#pragma once

#include <glm/mat4x3.hpp>
#include <span>
#include <vector>

#include "host/image/memory.h"
#include "host/scene/scene.h"
#include "host/tree/tree.h"
#include "units/options.h"

namespace dynrt::host {

/// What a configuration of the core takes objects for.
struct ImageForm {
  const MemoryFormat* format = &kShippedFormat;
  TriangleMatrix triangles = TriangleMatrix::kNormalConsistent;
  /// Every object lies in the memory such that its box is the cube from -1 to 1, to which the core
  /// clips (units/box_clip.h).
  bool boxes_are_cubes = false;
  /// For a watertight test a triangle's columns are its corners and its unit normal.
  TriangleTest triangle_test = TriangleTest::kUnitTriangle;
  unsigned address_bits = kAddressBits;  ///< the core reaches so many nodes, and list entries
  unsigned matrix_bits = kMatrixBits;    ///< and so many matrices
  bool one_colour = false;               ///< the core has one for all surfaces
  unsigned levels = 2;  ///< of trees; 1: of one object, which lies in the world as it is
};

/// Throws UserError for a scene that the memory cannot hold, or the core not reach, whatever its
/// trees are: with more triangles, instances and camera than there are matrices.
void check_matrices(const Scene& scene, const ImageForm& form = {});

/// Matrices of four columns that so many numbers of primitives take.
std::size_t matrices_taken(std::size_t numbers, TriangleMatrix form);

/// The matrices of an object's primitives, the first of which is `first`, as hit records name them;
/// behind the last primitive's, where the next object begins.
std::vector<std::uint32_t> matrix_numbers(const Scene& scene, const Mesh& object,
                                          std::uint32_t first, TriangleMatrix form);

/// The static part. Throws UserError where a limit of the memory is passed or a triangle's matrix
/// is beyond the core's numbers.
struct ObjectImage {
  /// Where an object lies.
  struct Object {
    std::uint32_t root = 0;          ///< for rays that start inside its box
    std::uint32_t clipped_root = 0;  ///< for all others
    std::uint32_t first_matrix = 0;  ///< of primitive 0, in the numbers of primitives
    Aabb box;
    glm::dmat4 to_space{1.0};  ///< from the object as it is to the space that the core has it in
  };
  std::vector<Object> objects;
  MemoryPart memory;
  ImageForm form;

  ObjectImage() = default;
  ObjectImage(const Scene& scene, std::span<const Tree> trees, const ImageForm& form = {});

  std::vector<Aabb> boxes() const;
  /// What is left of the memory for the top-level tree.
  TreeSize room_left() const;
};

/// The part that belongs to one frame. Throws UserError where a limit of the memory is passed, an
/// instance has no inverse or the core's numbers cannot hold it, or the camera is beyond them; for
/// a core of one level where there is more than one object, which is nothing but itself. Such a
/// core needs neither the instances' tree nor their matrices.
struct FrameImage {
  MemoryPart memory;
  std::uint32_t start_node = 0;
  std::uint32_t first_instance = 0;  ///< matrix of instance 0, or where it would be
  std::uint32_t camera_matrix = 0;
  std::uint32_t light_matrix = 0;  ///< of light 0
  std::uint32_t colour = 0;        ///< of the first surface; of all, where the core has but one

  FrameImage() = default;
  FrameImage(const Scene& scene, const ObjectImage& objects, const Tree& instances,
             const Camera& camera, unsigned width, unsigned height);
};

/// A surface's colour as its matrix holds it: 0x00BBGGRR.
std::uint32_t colour_bits(const glm::dvec3& colour);

/// Whether some triangle of the scene reflects. Then the matrix of every instance is followed by
/// the one back to the world, and a mirror's by its reflection (thesis 6.2.3).
bool has_mirrors(const Scene& scene);

/// What a frame and the objects below it take of the memory.
struct MemoryUse {
  std::size_t nodes = 0;  ///< with the null node
  std::size_t list_entries = 0;
  std::size_t matrices = 0;         ///< places of four columns
  double word_bytes = 4;            ///< of the scene's banks
  double tree_megabytes() const;    ///< nodes and lists, 10^6 bytes
  double matrix_megabytes() const;  ///< 10^6 bytes
};
MemoryUse memory_use(const FrameImage& frame);

/// From pixel coordinates to the primary ray: the pre-primary ray (0, 0, 0), (x, y, 1) of pixel
/// (x, y), x from the left and y from the top, becomes the camera's ray through the pixel's centre
/// (thesis 6.2.1).
glm::dmat4x3 camera_matrix(const Camera& camera, unsigned width, unsigned height);

}  // namespace dynrt::host
