// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/loaded_scene.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "host/scene/animation.h"

namespace dynrt::host {

LoadedScene::LoadedScene(MemoryImage image)
    : image_(std::move(image)),
      seconds_(duration(image_.scene)),
      instances_(image_.trees.instances) {}

Viewpoint LoadedScene::first() const { return viewpoint_of(image_.view.camera); }

std::optional<Viewpoint> LoadedScene::on_path(double time) const {
  const Scene& scene = image_.scene;
  if (scene.path.empty() && !scene.camera_motion) return std::nullopt;
  const auto camera = camera_at(scene, time);
  if (!camera) return std::nullopt;
  Viewpoint from = viewpoint_of(*camera);
  from.time = time;
  return from;
}

Viewpoint LoadedScene::viewpoint_of(const Camera& camera) const {
  constexpr double kLean = 1e-6;
  Viewpoint from;
  from.position = image_.space.outside(camera.position);
  from.look_at = image_.space.outside(camera.position + glm::normalize(camera.forward));
  from.up = image_.scene.path_up;
  if (std::abs(glm::dot(glm::normalize(camera.right), glm::normalize(from.up))) > kLean) {
    from.up = glm::normalize(camera.up);
  }
  from.field_of_view = field_of_view_of(camera);
  return from;
}

Camera LoadedScene::camera(const Viewpoint& from, unsigned width, unsigned height) const {
  return moved_into(image_.space, look_at(from.position, from.look_at, from.up, from.field_of_view,
                                          static_cast<double>(width) / height));
}

void LoadedScene::move(double time) {
  if (time == time_) return;
  move_to(image_.scene, time);
  instances_ = instances_of(image_);
  time_ = time;
}

FrameImage LoadedScene::frame(const Camera& camera, unsigned width, unsigned height) const {
  return {image_.scene, image_.objects, instances_, camera, width, height};
}

Frame Renderer::render(const LoadedScene& loaded, const FrameImage& image,
                       const FrameOptions& options) {
  if (held_ != &loaded) {
    held_ = nullptr;
    on_board_.clear();
    for (const MemoryRun& run : loaded.image().objects.memory.runs()) {
      board_->write(run.bank, run.address, run.words);
    }
    held_ = &loaded;
  }
  std::vector<MemoryRun> runs = image.memory.runs();
  const auto changed = changed_runs(std::exchange(on_board_, {}), runs, core().format->bus_words());
  Frame frame = host::render(*board_, options, image, changed);
  on_board_ = std::move(runs);
  return frame;
}

}  // namespace dynrt::host
