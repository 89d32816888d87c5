// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the ULX3S.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kChipNotSetUp[] =
    "the controller of the simulated ULX3S has not set its SDRAM up within a millisecond";
inline constexpr char kChipFault[] =
    "the simulated ULX3S does to its SDRAM what the chip's data sheet forbids: {}";
inline constexpr char kNoVerilogOfBoards[] =
    "this build has no Verilog of the ULX3S and of other boards at a serial line; run scripts/test "
    "--build-only, which makes it";
inline constexpr char kUnknownBitstream[] =
    "board {}: its bitstream has configuration {}, which this program does not know at a serial "
    "line; load a bitstream that has {}";
inline constexpr char kNoPicture[] =
    "the monitor at the DVI pins of the simulated ULX3S has seen no frame within 100 milliseconds";
inline constexpr char kBadPicture[] =
    "the monitor at the DVI pins of the simulated ULX3S cannot show what it sees: {}";
inline constexpr char kOtherMode[] =
    "the monitor at the DVI pins of the simulated ULX3S sees a mode of {}x{} pixels in place of "
    "{}x{}";

}  // namespace dynrt::host::messages
