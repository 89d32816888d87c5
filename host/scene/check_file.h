// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Checks for mistakes that Assimp does not report. They read a file before Assimp does and refuse
// it if Assimp would read another scene, never end or crash. All other checks are left to Assimp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dynrt::host {

/// Throws UserError when the file is missing, a folder, unreadable or empty.
void require_file(const std::string& path);

/// The whole file; throws as require_file.
std::string read_file(const std::string& path);

/// Assimp reads a number up to its first invalid character, drops a vertex of fewer than three
/// numbers, which renumbers all later vertices, and turns a face of two vertices into a line.
/// Throws UserError with the line. Returns the names of the material files that the file uses.
std::vector<std::string> check_obj(std::string_view text, const std::string& path);

/// Assimp invents the missing end of a file that was cut off, reads a number of an unknown type as
/// zero, and never returns from a header without an end. Throws UserError. Returns the text that
/// Assimp must read instead of the file's: after a header whose last line ends with a single
/// newline, Assimp would skip the first byte of the data if it is a newline too.
std::string mended_ply(std::string text, const std::string& path);

struct MendedGltf {
  std::string text;            ///< Assimp must read this instead of the file's
  std::size_t bare_skins = 0;  ///< skins without matrices, which no node of `text` has any more
};

/// Deeply nested nodes overflow the stack in Assimp's recursion, and Assimp invents a keyframe for
/// an animation without any. Throws UserError for these, and with the line for JSON that cannot be
/// parsed. Assimp crashes on a skin without matrices, so it gets a text without such skins. `text`
/// is a .gltf or a .glb file.
MendedGltf mended_gltf(std::string text, const std::string& path);

}  // namespace dynrt::host
