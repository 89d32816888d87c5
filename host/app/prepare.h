// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From a scene's name to the words that are uploaded: load, place the camera, build the trees,
// pack.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/app/arguments.h"
#include "host/board/board.h"
#include "host/image/fit.h"
#include "host/image/image.h"
#include "host/scene/check_lights.h"
#include "host/scene/scene.h"
#include "host/specialise/scene_needs.h"
#include "host/tree/scene_trees.h"

namespace dynrt::host {

/// Scene and camera are those of the core's space (host/image/fit.h), the hits' distances too.
struct Prepared {
  Scene scene;
  Camera camera;
  Space space;  ///< of the world
  Headroom headroom;
  int top_depth = kMaxTreeDepth;  ///< that the top-level tree may have, in every frame
  TreeSize top_room;              ///< and what it may take
  TriangleMatrix matrix = TriangleMatrix::kNormalConsistent;  ///< what is stored of a triangle
  SceneTrees trees;
  ObjectImage objects;
  FrameImage frame;
  double load_seconds = 0;
  double tree_seconds = 0;

  std::size_t triangles() const;  ///< of all objects, each counted once
  std::size_t rectangles() const;
  std::size_t spheres() const;
  std::size_t instanced_triangles() const;  ///< of all instances
  /// What the user should know: what the import took otherwise, which trees were cut.
  std::vector<std::string> notes() const;
  /// The scene, its trees and the memory they take, as data and as lines of text.
  nlohmann::ordered_json json() const;
  std::string text() const;
};

/// How a board of this kind wants its memory.
ImageForm form_for(const BoardInfo& board);

/// For a board of this kind: throws UserError where its configuration lacks one of the scene's
/// primitives, and Exceeded where it was made for a scene that needs less; judges the scene's
/// lights and mirrors. Trees that push more than the stacks of another board hold are built again,
/// so shallow that they never do. Without a board it is that of the configuration thesis, with
/// every primitive, and neither lights nor mirrors are judged.
Prepared prepare(const SceneArguments& arguments, unsigned width, unsigned height,
                 const BoardInfo* board = nullptr);
/// The same for a scene that is there, seen by a camera of its space.
Prepared prepare(Scene scene, const Camera& camera, unsigned width, unsigned height,
                 const BoardInfo* board = nullptr);

/// What the scene needs as it is laid out.
SceneNeeds needs_of(const Prepared& prepared);

/// For check_lights(): what a board makes of the numbers of a scene in a space.
CoreNumbers core_numbers(const BoardInfo& board, const Space& space);

}  // namespace dynrt::host
