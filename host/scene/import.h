// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Files of triangles through Assimp. An OBJ or PLY file becomes one object with one instance. A
// glTF node graph keeps its instances: every node with a mesh is an Instance with the transforms
// from the root accumulated, and nodes that name the same mesh share one object. Assimp's own
// joining of vertices and its removal of degenerate triangles work with fixed epsilons and are not
// asked for; MeshBuilder does both exactly.
#ifndef DYNRT_HOST_SCENE_IMPORT_H_
#define DYNRT_HOST_SCENE_IMPORT_H_

#include <string>

#include "host/scene/scene.h"

namespace Assimp {
class IOSystem;
}

namespace dynrt::host {

Scene import_file(const std::string& path);

// An OBJ file in another place than the disk, such as a zip library. `files` opens it and the
// material files that it names; `text` is its content and `label` what messages call it.
Scene import_obj(Assimp::IOSystem& files, const std::string& path, const std::string& text,
                 const std::string& label);

// Throws UserError, naming the node, unless the transform is affine, finite and has an inverse.
void require_inverse(const Instance& instance, const std::string& label);

}  // namespace dynrt::host

#endif  // DYNRT_HOST_SCENE_IMPORT_H_
