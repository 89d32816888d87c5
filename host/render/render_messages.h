// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the renderer. The program puts the flag before them, if the command has one.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kSize[] =
    "an image of {}x{} pixels is impossible: it has 1 to {} pixels a side and at most {} in all; "
    "the board's framebuffer and hit records hold no more";
inline constexpr char kPitch[] =
    "configuration {} cannot hold an image of {}x{} pixels: its rows begin {} pixels apart in the "
    "memory, which holds {} pixels";
inline constexpr char kPackets[] = "configuration {} holds 1 to {} packets, not {}";
inline constexpr char kLines[] =
    "the caches of configuration {} have {}, {}, {} up to {} lines, not {}";
inline constexpr char kUncompressed[] =
    "configuration {} transforms one origin for all rays of a packet and cannot transform one for "
    "each ray; take another configuration";
inline constexpr char kReflections[] =
    "configuration {} traces at most {} reflections of a ray, not {}";

inline constexpr char kNoPort[] =
    "the scene of configuration {} lies in banks of SRAM, whose clocks are its own; a "
    "configuration "
    "with \"memory\": \"port\" has a memory whose clocks can be chosen";
inline constexpr char kMemoryClocks[] = "the emulated memory takes {} to {} clocks, not {}";

}  // namespace dynrt::host::messages
