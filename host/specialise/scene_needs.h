// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a scene asks of the core that renders it: the figures that a configuration is decided by
// (decide.h), and that a later frame is held against (within.h). Found from the scene, its trees
// and its memory; for one that moves, from every frame together.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "host/memory/matrix_numbers.h"
#include "host/tree/scene_trees.h"

namespace dynrt::host {

struct SceneNeeds {
  /// Of the tree, or of the object's tree, that asks for most.
  struct Stack {
    int pushes = 0;
    std::string tree;
  };
  /// Items of one tree, and how many of them a packet may find again.
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

  /// What both ask for.
  void include(const SceneNeeds& other);
};

/// `form` is what is stored of a triangle.
SceneNeeds scene_needs(const Scene& scene, const SceneTrees& trees,
                       TriangleMatrix form = TriangleMatrix::kNormalConsistent);

/// Of the same scene in another frame: what its instances and the tree over them ask for.
SceneNeeds frame_needs(const SceneNeeds& before, const Scene& scene, const Tree& instances);

}  // namespace dynrt::host
