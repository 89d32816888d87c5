// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the renderer.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kSize[] =
    "--size {}x{}: an image has 1 to {} pixels a side and at most {} in all; the board's "
    "framebuffer and hit records hold no more";
inline constexpr char kPackets[] = "--packets {}: configuration {} holds 1 to {} packets";
inline constexpr char kLines[] =
    "--lines {}: the caches of configuration {} have 1, 2, 4 up to {} lines";
inline constexpr char kUncompressed[] =
    "--uncompressed: configuration {} can only transform one origin for all rays of a packet; "
    "leave the flag out";
inline constexpr char kReflections[] =
    "--reflections {}: configuration {} traces at most {} reflections of a ray";

}  // namespace dynrt::host::messages
