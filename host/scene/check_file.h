// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Assimp takes a file that was cut off, or garbage between good lines, and silently gives what it
// could make out. These checks read the same file first and refuse what cannot be right, with the
// line. They decide nothing about the geometry: that stays Assimp's.
#ifndef DYNRT_HOST_SCENE_CHECK_FILE_H_
#define DYNRT_HOST_SCENE_CHECK_FILE_H_

#include <string>
#include <string_view>
#include <vector>

namespace dynrt::host {

// The whole file. Throws UserError when it is missing, a folder, unreadable or empty.
std::string read_file(const std::string& path);

// Each statement is known, each vertex has three finite numbers, each face at least three vertices
// that exist. Gives the names of the material files that it asks for.
std::vector<std::string> check_obj(std::string_view text, const std::string& path);

// The header is whole, the body has all elements that it announces (ASCII: that many lines, all
// numbers; binary: that many bytes) and each face's vertices exist.
void check_ply(std::string_view text, const std::string& path);

// The JSON of a .gltf or inside a .glb can be parsed, its nodes are not nested so deeply that
// Assimp's recursion would overflow the stack, and a .glb is as long as it says.
void check_gltf(std::string_view text, const std::string& path);

}  // namespace dynrt::host

#endif  // DYNRT_HOST_SCENE_CHECK_FILE_H_
