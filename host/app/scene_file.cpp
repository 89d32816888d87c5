// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/scene_file.h"

#include <chrono>
#include <utility>

#include "host/app/progress.h"
#include "host/scene/load.h"

namespace dynrt::host {

const Scene& SceneFile::scene() {
  if (!scene_) {
    const Progress progress("loading " + arguments_.scene);
    const auto begin = std::chrono::steady_clock::now();
    scene_ = load_scene(arguments_.scene);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  return *scene_;
}

Scene SceneFile::take() {
  if (again_) return scene();
  scene();
  return std::move(*std::exchange(scene_, std::nullopt));
}

}  // namespace dynrt::host
