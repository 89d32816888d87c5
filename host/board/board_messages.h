// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the boards.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kTimeout[] =
    "board {}: no interrupt and no pixel for {} clocks (a longer timeout allows more); {} pixels "
    "are "
    "written, status {:#x}, the units stand at {}";
inline constexpr char kAssertion[] =
    "the Verilog's assertion that is printed above fails in clock {} of the board";
inline constexpr char kBusHangs[] =
    "board {}: the bus waits for ever at address {:#x}; the Verilog below it is broken";
inline constexpr char kWrongId[] =
    "board {}: reads {:#x} as its id and {:#x} as its version, expected {:#x} and {:#x}; "
    "rebuild the Verilog and the host together";
inline constexpr char kFrameWords[] =
    "board {}: has {} frame registers, the host writes {}; rebuild the Verilog and the host "
    "together";
inline constexpr char kRefused[] =
    "board {}: refused an access during the frame; the SRAM and the frame's registers "
    "belong to the core until the interrupt";
inline constexpr char kOutsideBank[] =
    "board {}: words {} to {} of bank {} are asked for; there are {} banks of {} words";
inline constexpr char kNoConfiguration[] =
    "configuration {}: unknown; this build has {}, and a file FILE.json or FILE.so may be named "
    "instead";
inline constexpr char kNoConfigurationFile[] = "configuration {}: there is no such file";
inline constexpr char kNotMade[] = "{}: {}";
inline constexpr char kNotALibrary[] =
    "configuration {}: is no whole shared library; make it again with scripts/configuration";
inline constexpr char kNotLoaded[] = "configuration {}: cannot be loaded: {}";
inline constexpr char kForeignLibrary[] =
    "configuration {}: is a shared library, but no configuration of dynrt; scripts/configuration "
    "makes "
    "those";
inline constexpr char kOtherBuild[] =
    "configuration {}: was made of other sources or by another compiler than this program; make it "
    "again "
    "with scripts/configuration";
inline constexpr char kNoBoard[] = "board {}: unknown; the boards are rtl and model";
inline constexpr char kModelAlone[] =
    "configuration {}: is the native model alone, so it has no board rtl; take one of those with "
    "Verilog, "
    "{}, or give it \"rtl\": true in hls/configs/configs.json and build again";
inline constexpr char kWideWords[] =
    "configuration {}: a float of {} bits needs words of {} bits in the memory, and the SRAM of "
    "board "
    "rtl has {}; take board model";
inline constexpr char kNoRtl[] =
    "board rtl: the Verilog of configuration {} is not part of this build; configure with "
    "-DDYNRT_RTL=ON or take board model";
inline constexpr char kNoTrace[] =
    "waveforms: only board rtl has signals to record; ask for none or take that board";
inline constexpr char kScheduleOfRtl[] =
    "schedules: only board model takes its clocks from them, as the Verilog has clocks of its own; "
    "name none or take that board";
inline constexpr char kNoSchedule[] =
    "{}: the folder has no schedules of hlsc; name that of a configuration's Verilog, such as "
    "build/release/generated/thesis";
inline constexpr char kBadSchedule[] =
    "{}: is not a whole schedule of hlsc; lower the unit again or remove the file";
inline constexpr char kIncompleteSchedule[] =
    "{}: {} of configuration {}; name the folder of that configuration's Verilog";
inline constexpr char kScanWords[] =
    "board {}: has {} registers for its scan-out, the host writes {}; rebuild the Verilog and the "
    "host together";
inline constexpr char kNoScanOut[] =
    "board {} of configuration {} has no scan-out; take board rtl and a configuration with the key "
    "scan_out, such as thesis";
inline constexpr char kDisplaySize[] =
    "a picture of {}x{} does not fit the display of {}x{}; render a smaller one";
inline constexpr char kTrace[] = "{}: cannot be written; name a file in a folder that can";

}  // namespace dynrt::host::messages
