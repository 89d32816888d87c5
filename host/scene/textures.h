// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Textures, which the core does not render: a material with one gets one colour in place of it.
#pragma once

#include <string>

#include "host/scene/scene.h"

struct aiScene;
namespace Assimp {
class IOSystem;
}

namespace dynrt::host {

/// Multiplies the colour of every material that has a base colour texture by the mean colour of the
/// texture. A texture lies in the file itself or in one that `files` opens, beside `path`. Notes in
/// the scene, as `label`, how many textures there are and which of them cannot be read.
void mix_textures(const aiScene& from, Assimp::IOSystem& files, const std::string& path,
                  const std::string& label, Scene& scene);

}  // namespace dynrt::host
