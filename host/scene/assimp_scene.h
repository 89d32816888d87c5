// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Converts Assimp's scene to a Scene: materials, objects, instances, the first perspective camera,
// point lights, and the first animation of its nodes. A material that is metallic and polished is a
// mirror. Values between keyframes are interpolated linearly, even if the file asks for another
// interpolation.
#pragma once

#include <string>

#include "host/scene/scene.h"

struct aiScene;

namespace dynrt::host {

/// The meaning of Assimp's nodes in a file's format.
enum class AssimpForm {
  kOneMesh,  ///< nothing: the file is one object with one instance
  kNodes,    ///< instances, cameras and lights, as Assimp documents them
  kGltf,     ///< the same, but Assimp 5.2 gives a camera otherwise than it documents
};

/// Throws UserError, naming the node, for a transform, a camera, a light or a keyframe that cannot
/// be used.
Scene convert_assimp(const aiScene& from, const std::string& label, AssimpForm form);

/// Drops the animation if it moves neither an instance nor the camera: an animation of bones.
void rest_if_nothing_moves(Scene& scene);

}  // namespace dynrt::host
