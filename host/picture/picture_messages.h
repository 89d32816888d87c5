// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages about pictures and other files that cannot be written or read.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kExtension[] =
    "{}: dynrt does not write the image format '{}'; the name must end in .png or .exr";
inline constexpr char kNotAPicture[] =
    "{}: this file is no longer the picture that dynrt wrote; remove it and run the same command "
    "again";
inline constexpr char kSameFile[] = "{} {}: {} writes the same file; name another file";
inline constexpr char kNoFolder[] =
    "{}: there is no folder '{}'; create it or name a file elsewhere";
inline constexpr char kCannotWrite[] =
    "{}: cannot write this file ({}); name a file in a folder that can be written";
inline constexpr char kNoImageLibrary[] =
    "pictures need dynrt's library {}, which cannot be loaded ({}); build it again or put it into "
    "the program's folder";

}  // namespace dynrt::host::messages
