// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core does not render textures: a material with a texture gets one colour instead.
#pragma once

#include <string>

#include "host/scene/scene.h"

struct aiScene;
namespace Assimp {
class IOSystem;
}

namespace dynrt::host {

/// Multiplies the colour of every material that has a base colour texture by the mean colour of the
/// texture. A texture lies in the file itself or in a file next to `path` that `files` opens. Adds
/// notes to the scene, under the name `label`: the number of textures and those that cannot be
/// read.
void mix_textures(const aiScene& from, Assimp::IOSystem& files, const std::string& path,
                  const std::string& label, Scene& scene);

}  // namespace dynrt::host
