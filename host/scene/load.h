// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one way into a scene: a built-in name (scenes/NAME.json) or the path of a file that Assimp
// reads (OBJ, PLY, STL, glTF, COLLADA, FBX and some forty others), of a Quake 3 map (FILE.bsp, or
// FILE.pk3:NAME for one of a package) or of a description like those in scenes/. Throws UserError
// for anything wrong with it.
#pragma once

#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace dynrt::host {

Scene load_scene(const std::string& name_or_path);

/// The built-in names, sorted.
std::vector<std::string> built_in_scenes();

}  // namespace dynrt::host
