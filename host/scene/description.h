// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A scene put together from parts, described in JSON; scenes/README.md has the keys. Lengths in
// metres, y up, angles in degrees, turns counterclockwise seen from the axis' tip.
#pragma once

#include <string>

#include "host/scene/furniture.h"
#include "host/scene/map.h"
#include "host/scene/scene.h"

namespace dynrt::host {

/// The folders of the Debian packages with models and maps; opened only if a part needs one.
struct Packages {
  std::string furniture = kFurnitureFolder;
  std::string maps = kMapPackage;
};

Scene load_description(const std::string& path, const Packages& packages = {});

}  // namespace dynrt::host
