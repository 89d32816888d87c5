// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The needs of a scene: the figures that decide a configuration (decide.h), and that later frames
// are compared with (within.h). They come from the scene, its trees and its memory; for a moving
// scene, from all its frames.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "host/memory/matrix_numbers.h"
#include "host/tree/scene_trees.h"

namespace dynrt::host {

struct SceneNeeds {
  /// Of the tree, or of the object's tree, that needs most.
  struct Stack {
    int pushes = 0;
    std::string tree;
  };
  /// The items of one tree, and the number of them that a packet may find again.
  struct Repeats {
    std::size_t items = 0;
    std::size_t repeated = 0;
    std::string tree;
  };
  struct Counts {
    std::size_t triangles = 0, rectangles = 0, spheres = 0;
  };

  unsigned frames = 1;  ///< that this was found from
  std::string scene;
  std::size_t objects = 0, instances = 0;
  /// One object, one instance, and nothing to transform between the two, in any frame.
  bool one_level = false;
  bool main_first = false;  ///< rays enter one instance before the tree, in some frame
  Stack top_stack, object_stack;
  Repeats instance_repeats, primitive_repeats;
  Counts primitives;
  std::size_t lights = 0;
  std::string mirror;               ///< the name of a material that reflects, or empty
  std::set<std::uint32_t> colours;  ///< 0x00BBGGRR, of the primitives that there are
  /// Addresses of nodes and list entries and numbers of matrices in use, from 0: of the objects
  /// alone, and with what a frame adds.
  struct Places {
    std::size_t nodes = 0, entries = 0, matrices = 0;
  };
  Places still, places;
  std::size_t boxes_of_instance = 0;  ///< in the memory, for the core to test

  /// The needs of both.
  void include(const SceneNeeds& other);
};

/// `form` is the form in which triangles are stored.
SceneNeeds scene_needs(const Scene& scene, const SceneTrees& trees,
                       TriangleMatrix form = TriangleMatrix::kNormalConsistent,
                       std::size_t boxes_of_instance = 0);

/// The needs of the same scene's instances, and of the tree over them, in another frame.
SceneNeeds frame_needs(const SceneNeeds& before, const Scene& scene, const Tree& instances);

}  // namespace dynrt::host
