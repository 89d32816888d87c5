// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Files that Assimp reads. A file of one mesh (OBJ, PLY, STL, OFF) becomes one object with one
// instance. A graph of nodes keeps its instances: every node with a mesh is an Instance with the
// transforms from the root accumulated, and nodes that name the same mesh share one object.
// Assimp joins vertices and removes degenerate triangles with fixed epsilons, so both are off;
// MeshBuilder does both exactly.
#pragma once

#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace Assimp {
class IOSystem;
}

namespace dynrt::host {

/// The extensions that Assimp reads, sorted, each with its point.
std::vector<std::string> assimp_extensions();

/// Reads a file on the disk. Throws UserError if its extension is none of those.
Scene import_file(const std::string& path);

/// Says whether materials get the mean colours of their textures (textures.h).
enum class Textures { kMixed, kIgnored };

/// Reads an OBJ file that is not on the disk but, for example, in a zip library. `files` opens the
/// material files that it names; `text` is its content and `label` its name in messages.
Scene import_obj(Assimp::IOSystem& files, const std::string& path, const std::string& text,
                 const std::string& label, Textures textures);

/// Throws UserError, naming the node, unless the transform is affine, finite and has an inverse.
void require_inverse(const Instance& instance, const std::string& label);

}  // namespace dynrt::host
