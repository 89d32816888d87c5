// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene that was loaded for the window: its memory image, which moves with the animation, and the
// camera's part of it. A renderer draws it on a board and uploads only the words that have changed
// since the frame before.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "host/layout/lay_out.h"
#include "host/render/render.h"

namespace dynrt::host {

/// Where the camera is and where it looks, in the file's space.
struct Viewpoint {
  glm::dvec3 position{0.0}, look_at{0.0}, up{0.0, 1.0, 0.0};
  double field_of_view = kDefaultFieldOfView;
  double time = 0;  ///< of the scene's animation
};

class LoadedScene {
 public:
  explicit LoadedScene(MemoryImage image);

  const MemoryImage& image() const { return image_; }
  const CoreInfo& core() const { return image_.core(); }
  /// Seconds of its animation; 0 if nothing moves.
  double seconds() const { return seconds_; }
  /// The camera that the scene was prepared with, in the file's space. `up` is the scene's, unless
  /// the camera leans to a side.
  Viewpoint first() const;

  /// The place of the scene's own camera at a moment; nothing if that camera does not move.
  std::optional<Viewpoint> on_path(double time) const;

  /// The same camera in the core's space. Throws UserError for a view that no camera has.
  Camera camera(const Viewpoint& from, unsigned width, unsigned height) const;
  /// Moves the scene to a moment of its animation; later frames show that moment.
  void move(double time);
  /// The frame's part of the memory. Throws UserError for a camera beyond the core's numbers.
  FrameImage frame(const Camera& camera, unsigned width, unsigned height) const;

 private:
  Viewpoint viewpoint_of(const Camera& camera) const;

  MemoryImage image_;
  double seconds_;
  double time_ = 0;
  Tree instances_;
};

/// A board, and the scene whose objects are in its memory.
class Renderer {
 public:
  explicit Renderer(std::unique_ptr<Board> board) : board_(std::move(board)) {}

  const CoreInfo& core() const { return board_->core(); }
  Board& board() { return *board_; }
  /// Uploads the objects if the board holds those of another scene, and those words of the frame
  /// that differ; then renders.
  Frame render(const LoadedScene& loaded, const FrameImage& image, const FrameOptions& options);

 private:
  std::unique_ptr<Board> board_;
  const LoadedScene* held_ = nullptr;
  std::vector<MemoryRun> on_board_;  ///< of the frame that the board holds
};

}  // namespace dynrt::host
