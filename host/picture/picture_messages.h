// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages about pictures and other files that cannot be written or read.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kExtension[] =
    "{}: the image format '{}' is not one of dynrt's; the name must end in .png or .exr";
inline constexpr char kNotAPicture[] =
    "{}: is no longer the picture that was written; remove it and run the same command again";
inline constexpr char kSameFile[] = "{} {}: {} writes the same file; name another one";
inline constexpr char kNoFolder[] =
    "{}: there is no folder '{}'; create it or name a file elsewhere";
inline constexpr char kCannotWrite[] =
    "{}: cannot be written ({}); name a file in a folder that can";
inline constexpr char kNoImageLibrary[] =
    "pictures need dynrt's library {}, which cannot be loaded ({}); build it again or put it "
    "beside "
    "the program";

}  // namespace dynrt::host::messages
