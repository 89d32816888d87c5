// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the renderer and the image writer say when something is wrong.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kSize[] =
    "--size {}x{}: an image has 1 to {} pixels a side and at most {} in all, which is what the "
    "board's framebuffer and hit records hold";
inline constexpr char kPackets[] = "--packets {}: configuration {} holds 1 to {} packets";
inline constexpr char kLines[] =
    "--lines {}: the caches of configuration {} have 1, 2, 4 up to {} lines";
inline constexpr char kUncompressed[] =
    "--uncompressed: configuration {} transforms one origin for all rays of a packet; leave the "
    "flag out";
inline constexpr char kReflections[] =
    "--reflections {}: configuration {} traces at most {} reflections of a ray";
inline constexpr char kExtension[] =
    "{}: the image format '{}' is not one of dynrt's; the name must end in .png or .exr";
inline constexpr char kNotAPicture[] =
    "{}: is no longer the picture that was written; remove it and run the same command again";
inline constexpr char kSameFile[] = "{} {}: {} writes the same file; name another one";
inline constexpr char kNoFolder[] =
    "{}: there is no folder '{}'; create it or name a file elsewhere";
inline constexpr char kCannotWrite[] =
    "{}: cannot be written ({}); name a file in a folder that can";

}  // namespace dynrt::host::messages
