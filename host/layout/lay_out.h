// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one way from a scene to the words of the board's memory: fit it to the core's numbers, build
// its trees, lay out the static part (ObjectImage) and the part of one frame
// (FrameImage).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/layout/core_trees.h"
#include "host/layout/fit.h"
#include "host/layout/frame_image.h"
#include "host/scene/check_lights.h"
#include "host/specialise/within.h"

namespace dynrt::host {

/// The camera of a picture, and its size in pixels.
struct View {
  Camera camera{};
  unsigned width = 512;
  unsigned height = 384;
};

struct LayoutOptions {
  /// Move and scale the scene to the core's numbers; otherwise it must already lie in the core's
  /// space.
  bool fit = true;
  /// Rebuild trees that could overflow the core's stacks, so shallow that they cannot.
  bool spare_stacks = true;
  TreeOptions trees{};
  std::optional<BoxTreeOptions> instances{};  ///< of the top-level tree, if not those of `trees`
  std::optional<SceneTrees> built{};          ///< in place of building any
};

/// Scene, camera and the distances of hits are in the core's space (fit.h).
struct MemoryImage {
  Scene scene;
  View view;
  Space space;  ///< of the world
  Headroom headroom;
  int top_depth = kMaxTreeDepth;  ///< levels that the top-level tree may have
  TreeSize top_room;              ///< memory that it may take
  SceneTrees trees;
  ObjectImage objects;
  FrameImage frame;
  double tree_seconds = 0;  ///< time to build the trees

  /// Of no scene yet.
  explicit MemoryImage(CoreInfo core) : objects(std::move(core)) {}

  /// The core that it is laid out for.
  const CoreInfo& core() const { return objects.core; }
  /// All that is uploaded.
  std::vector<MemoryRun> runs() const;
  /// The needs of the scene as it is laid out.
  SceneNeeds needs() const;
};

/// Throws UserError if the scene exceeds the memory, the core's numbers or its parts, and Exceeded
/// if the core was specialised for a scene that needs less. Lights are checked if the core has rays
/// for them.
MemoryImage lay_out(Scene scene, const View& view, const CoreInfo& core,
                    const LayoutOptions& options = {});

/// Throws UserError, with the key, if an image for one core would be another for the core that is
/// to render it.
void check_laid_out_for(const MemoryImage& image, const CoreInfo& core);

/// The top-level tree of the scene as its instances stand now.
Tree instances_of(const MemoryImage& image);
/// The limit of a specialised core that the scene exceeds with that tree; nothing for a general
/// core. `needs` are those of the scene as it was laid out.
std::optional<Excess> excess_of_frame(const MemoryImage& image, const SceneNeeds& needs,
                                      const Tree& instances);
/// The frame's part for that tree, seen by a camera of the core's space.
FrameImage frame_of(const MemoryImage& image, const Tree& instances, const Camera& camera);

/// For check_lights(): the core's numbers for a scene in a space.
CoreNumbers core_numbers(const CoreInfo& core, const Space& space);

}  // namespace dynrt::host
