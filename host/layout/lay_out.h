// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one way from a scene to the words of the board's memory: fit it to the core's numbers, build
// its trees, lay out what stands still (ObjectImage) and what belongs to the frame (FrameImage).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/layout/core_trees.h"
#include "host/layout/fit.h"
#include "host/layout/frame_image.h"
#include "host/scene/check_lights.h"
#include "host/specialise/within.h"

namespace dynrt::host {

/// From where a picture is taken, and its size in pixels.
struct View {
  Camera camera{};
  unsigned width = 512;
  unsigned height = 384;
};

struct LayoutOptions {
  /// Move and scale the scene to the core's numbers; else it lies in the core's space already.
  bool fit = true;
  /// Build trees that could overflow the core's stacks again, so shallow that they never do.
  bool spare_stacks = true;
  TreeOptions trees{};
  std::optional<BoxTreeOptions> instances{};  ///< of the top-level tree, if not those of `trees`
  std::optional<SceneTrees> built{};          ///< in place of building any
};

/// Scene and camera are those of the core's space (fit.h), the hits' distances too.
struct MemoryImage {
  CoreInfo core;
  Scene scene;
  View view;
  Space space;  ///< of the world
  Headroom headroom;
  int top_depth = kMaxTreeDepth;  ///< that the top-level tree may have, in every frame
  TreeSize top_room;              ///< and what it may take
  SceneTrees trees;
  ObjectImage objects;
  FrameImage frame;
  double tree_seconds = 0;  ///< that building the trees took

  /// All that is uploaded.
  std::vector<MemoryRun> runs() const;
  /// What the scene needs as it is laid out.
  SceneNeeds needs() const;
};

/// Throws UserError where the scene exceeds the memory, the core's numbers or parts, and Exceeded
/// where the core was specialised for a scene that needs less. Lights are checked if the core has
/// rays for them.
MemoryImage lay_out(Scene scene, const View& view, const CoreInfo& core,
                    const LayoutOptions& options = {});

/// The top-level tree of the scene as its instances stand now.
Tree instances_of(const MemoryImage& image);
/// What the scene, with that tree, exceeds of a specialised core; nothing for a general one.
/// `needs` are those of the scene as it was laid out.
std::optional<Excess> excess_of_frame(const MemoryImage& image, const SceneNeeds& needs,
                                      const Tree& instances);
/// The frame's part for that tree, seen by a camera of the core's space.
FrameImage frame_of(const MemoryImage& image, const Tree& instances, const Camera& camera);

/// For check_lights(): the core's numbers for a scene in a space.
CoreNumbers core_numbers(const CoreInfo& core, const Space& space);

}  // namespace dynrt::host
