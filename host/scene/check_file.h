// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What Assimp gets wrong in silence: these checks read a file before Assimp does and refuse what
// Assimp would take for another scene, never end with, or crash on. They leave everything to Assimp
// that it reads or refuses rightly.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dynrt::host {

/// Throws UserError when the file is missing, a folder, unreadable or empty.
void require_file(const std::string& path);

/// The whole file; throws as require_file.
std::string read_file(const std::string& path);

/// Assimp reads a number up to its first strange character, drops a vertex of fewer than three
/// numbers, which renumbers all that follow, and makes a line of a face of two. Throws UserError
/// with the line. Gives the names of the material files that the file asks for.
std::vector<std::string> check_obj(std::string_view text, const std::string& path);

/// Assimp makes up what a file that was cut off lacks, reads a number of a type that it does not
/// know as zero, and never ends with a header that does not end. Throws UserError. Gives the text
/// that Assimp must get in place of the file's: behind a header whose last line ends in a newline
/// alone, Assimp skips a first byte of the data that is one too.
std::string mended_ply(std::string text, const std::string& path);

/// Assimp's recursion overflows the stack where nodes are nested deeply, Assimp makes up a keyframe
/// where an animation has none and crashes on a skin without matrices. Throws UserError for these,
/// and for JSON that cannot be parsed with its line. `text` is a .gltf or a .glb file.
void check_gltf(std::string_view text, const std::string& path);

}  // namespace dynrt::host
