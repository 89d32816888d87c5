// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Renders a scene frame after frame. Objects and camera move, the host rebuilds the top-level tree
// for each frame, and only the changed words of the memory go over the bus. The objects' trees and
// matrices are uploaded once. Two framebuffers take turns.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/render/render.h"

namespace dynrt::host {

/// The moments that are rendered.
struct WalkPlan {
  std::vector<double> times;  ///< seconds, one a frame
  double seconds = 0;         ///< duration of the walk
  bool orbit = false;  ///< nothing moves by itself: the camera goes round the scene's centre once

  /// Frames evenly spread from `from` (default: the animation's begin) to `to` (default: its end).
  /// Throws UserError for no frames and for times that do not rise.
  WalkPlan(const Scene& scene, unsigned frames, std::optional<double> from,
           std::optional<double> to);

  /// The camera at `time`, for the scene at that moment.
  Camera camera(const Scene& scene, const CameraOverrides& flags, double time, unsigned width,
                unsigned height) const;

 private:
  glm::dvec3 centre_{0.0};
};

/// The top-level tree of a frame. Moves the scene to the frame's moment.
Tree instances_at(MemoryImage& image, const WalkPlan& plan, unsigned frame);

/// The figures of a frame. `upload` counts the words that changed since the previous frame.
struct WalkRecord {
  unsigned frame = 0;
  double time = 0;
  std::optional<std::uint64_t> cycles;  ///< the model has none
  double simulation_seconds = 0;
  double tree_seconds = 0;  ///< to move the objects and build the top-level tree
  double pack_seconds = 0;  ///< to lay it out and find the changes
  BusTraffic upload;
  std::uint64_t words = 0;             ///< of the frame's part of the memory, changed or not
  std::size_t nodes = 0, entries = 0;  ///< of the top-level tree
  bool general = false;                ///< rendered on the general core, as it exceeded the other

  std::uint64_t uploaded_words() const { return upload.bytes_written / 4; }
  double upload_seconds() const { return upload.seconds(); }
};

class Walker {
 public:
  /// Moves the scene of `image`; `camera` is in the file's space. Throws UserError for an image
  /// that was laid out for another core.
  Walker(Board& board, const FrameOptions& options, MemoryImage& image,
         const CameraOverrides& camera, WalkPlan plan);

  const WalkPlan& plan() const { return plan_; }
  /// Of the objects' part of the memory, which is uploaded once.
  const BusTraffic& scene_upload() const { return scene_upload_; }

  struct Result {
    Frame frame;
    WalkRecord record;
  };
  /// Frames may be skipped: then the memory is first brought to the state after the previous frame,
  /// so that the record is the same. Throws Exceeded for a frame that exceeds the board's core.
  Result render_frame(unsigned frame, const PixelProgress& progress);

 private:
  struct Step {
    FrameImage frame;
    std::vector<MemoryRun> runs;
    std::optional<Excess> excess;  ///< limits of the board's core
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
