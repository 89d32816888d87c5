// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Scenes by their names in the memory of a core, seen as they are by default.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "host/layout/lay_out.h"
#include "host/scene/load.h"

namespace dynrt::host {

using ChangeScene = std::function<void(Scene&)>;

inline MemoryImage laid_out(const std::string& name, unsigned width, unsigned height,
                            const CoreInfo& core, const ChangeScene& change = {},
                            const LayoutOptions& options = {}) {
  Scene scene = load_scene(name);
  if (change) change(scene);
  const Camera camera = choose_camera(scene, {}, static_cast<int>(width), static_cast<int>(height));
  return lay_out(std::move(scene), {camera, width, height}, core, options);
}

}  // namespace dynrt::host
