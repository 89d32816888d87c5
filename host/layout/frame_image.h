// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The part of a scene's image that belongs to one frame: the top-level tree, the instances'
// matrices, the camera's and the lights'. It follows the objects' part, at the same place in every
// frame, and its size is known from the number of instances and of lights.
#pragma once

#include <glm/mat4x3.hpp>

#include "host/layout/object_image.h"

namespace dynrt::host {

/// The places of the scene's parts for the frame registers.
struct SceneAddresses {
  std::uint32_t start_node = 0;
  std::uint32_t others_node =
      0;  ///< where rays start that have met the main object, if there is one
  std::uint32_t camera_matrix = 0;
  std::uint32_t light_matrix = 0;  ///< of light 0
  unsigned lights = 0;
  std::uint32_t colour = 0;          ///< of the first surface; of all, where the core has but one
  std::uint32_t first_instance = 0;  ///< matrix of instance 0, or its place
  std::uint32_t box_column =
      0;  ///< column of an instance's box less the instance's matrix, if the core tests boxes
  std::uint32_t boxes_apart = 0;  ///< from the boxes for the eye to those for light 0, and so on
};

/// The part that belongs to one frame. Throws UserError where a limit of the memory is passed, an
/// instance has no inverse or the core's numbers cannot hold it, or the camera is beyond them; for
/// a core of one level if the scene is not a single object that lies in the world as it is. Such a
/// core needs neither the instances' tree nor their matrices.
struct FrameImage : SceneAddresses {
  MemoryPart memory;

  FrameImage() = default;
  FrameImage(const Scene& scene, const ObjectImage& objects, const Tree& instances,
             const Camera& camera, unsigned width, unsigned height);
};

/// The memory that a frame and its objects take.
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
