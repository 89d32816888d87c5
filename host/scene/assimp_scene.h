// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What Assimp made of a file as a Scene: materials, objects, instances, the first perspective
// camera, point lights, and the first animation of its nodes. A material that is metallic and
// polished is a mirror. Keyframes are joined evenly, whatever interpolation the file asks for.
#ifndef DYNRT_HOST_SCENE_ASSIMP_SCENE_H_
#define DYNRT_HOST_SCENE_ASSIMP_SCENE_H_

#include <string>

#include "host/scene/scene.h"

struct aiScene;

namespace dynrt::host {

// Flat: one object, one instance, no more. Throws UserError, naming the node, for a transform, a
// camera, a light or a keyframe that cannot be used.
Scene convert_assimp(const aiScene& from, const std::string& label, bool flat);

}  // namespace dynrt::host

#endif  // DYNRT_HOST_SCENE_ASSIMP_SCENE_H_
