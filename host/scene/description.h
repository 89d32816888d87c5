// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene put together from parts, described in JSON; scenes/README.md has the keys. Lengths in
// metres, y up, angles in degrees, turns counterclockwise seen from the axis' tip.
#ifndef DYNRT_HOST_SCENE_DESCRIPTION_H_
#define DYNRT_HOST_SCENE_DESCRIPTION_H_

#include <string>

#include "host/scene/furniture.h"
#include "host/scene/scene.h"

namespace dynrt::host {

// The furniture folder is opened only when a part asks for a model.
Scene load_description(const std::string& path,
                       const std::string& furniture_folder = kFurnitureFolder);

}  // namespace dynrt::host

#endif  // DYNRT_HOST_SCENE_DESCRIPTION_H_
