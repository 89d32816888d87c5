// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene frame after frame: objects and camera move, the top-level tree is built anew, and only
// the words of the memory that this changes go over the bus. The objects' own trees and matrices
// are uploaded once. A frame is rendered into the framebuffer that does not hold the one before.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/render/render.h"

namespace dynrt::host {

/// Which moments are rendered.
struct WalkPlan {
  std::vector<double> times;  ///< seconds, one a frame
  double seconds = 0;         ///< that the walk lasts
  bool orbit = false;  ///< nothing moves by itself: the camera goes round the scene's centre once

  /// Frames evenly spread from `from`, else the animation's begin, until `to`, else its end. Throws
  /// UserError for no frames and for times that do not rise.
  WalkPlan(const Scene& scene, unsigned frames, std::optional<double> from,
           std::optional<double> to);

  /// That of moment `time`, for the scene as it is then.
  Camera camera(const Scene& scene, const CameraOverrides& flags, double time, unsigned width,
                unsigned height) const;

 private:
  glm::dvec3 centre_{0.0};
};

/// The top-level tree of a frame, to whose moment the scene is moved.
Tree instances_at(MemoryImage& image, const WalkPlan& plan, unsigned frame);

/// What is reported of a frame. `upload` is of what changed since the frame before.
struct WalkRecord {
  unsigned frame = 0;
  double time = 0;
  std::optional<std::uint64_t> cycles;  ///< the model has none
  double simulation_seconds = 0;
  double tree_seconds = 0;  ///< to move the objects and build the top-level tree
  double pack_seconds = 0;  ///< to lay it out and find what changed
  BusTraffic upload;
  std::uint64_t words = 0;             ///< of the frame's part of the memory, changed or not
  std::size_t nodes = 0, entries = 0;  ///< of the top-level tree
  bool general = false;                ///< rendered on the general core, as it exceeded the other

  std::uint64_t uploaded_words() const { return upload.bytes_written / 4; }
  double upload_seconds() const;  ///< on 33 MHz PCI
};

class Walker {
 public:
  /// The scene of `image` is moved about; `camera` is in the file's space.
  Walker(Board& board, const FrameOptions& options, MemoryImage& image,
         const CameraOverrides& camera, WalkPlan plan);

  const WalkPlan& plan() const { return plan_; }
  /// Of the objects' part of the memory, once.
  const BusTraffic& scene_upload() const { return scene_upload_; }

  struct Result {
    Frame frame;
    WalkRecord record;
  };
  /// Frames may be left out: then the memory is first brought to what the frame before leaves, so
  /// that the record is the same. Throws Exceeded for a frame that the board was not made for.
  Result render_frame(unsigned frame, const PixelProgress& progress);

 private:
  struct Step {
    FrameImage frame;
    std::vector<MemoryRun> runs;
    std::optional<Excess> excess;  ///< of what a board is made for
    double tree_seconds = 0, pack_seconds = 0;
  };
  Step step_to(unsigned frame);
  void upload_scene();
  void write(const std::vector<MemoryRun>& runs);
  unsigned bus_words() const { return board_.core().format->bus_words(); }

  Board& board_;
  const FrameOptions options_;
  MemoryImage& image_;
  const CameraOverrides camera_;
  const WalkPlan plan_;
  BusTraffic scene_upload_;
  const SceneNeeds needs_;           ///< of the scene as it was prepared
  std::vector<MemoryRun> on_board_;  ///< of the frame that the board holds
  std::optional<unsigned> held_;     ///< its number
};

}  // namespace dynrt::host
