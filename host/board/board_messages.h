// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the boards.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kTimeout[] =
    "board {}: no interrupt and no pixel for {} clocks (a longer timeout allows more); {} pixels "
    "are written, the status is {:#x}, the units: {}";
inline constexpr char kAssertion[] =
    "an assertion of the Verilog, printed above, fails in clock {} of the board";
inline constexpr char kBusHangs[] =
    "board {}: the bus waits for ever at address {:#x}; the Verilog behind it is broken";
inline constexpr char kStaysBusy[] =
    "board {}: its core stays busy after a reset; press the board's reset, or load its bitstream "
    "again";
inline constexpr char kStandsStill[] =
    "board {}: its core has begun a frame and counts no clocks behind the {} that it has; press "
    "the board's reset, or load its bitstream again";
inline constexpr char kWrongId[] =
    "board {}: its registers give the id {:#x} and the version {:#x}, but the host expects {:#x} "
    "and {:#x}; rebuild the Verilog and the host together";
inline constexpr char kFrameWords[] =
    "board {}: it has {} frame registers, but the host writes {}; rebuild the Verilog and the host "
    "together";
inline constexpr char kRefused[] =
    "board {}: it refused an access during the frame; the SRAM and the frame's registers belong to "
    "the core until the interrupt";
inline constexpr char kMemoryError[] =
    "board {}: {} answered a {} of byte {:#x} of the core's memory, so the frame may be wrong; "
    "look at what stands behind the core's port at that address";
inline constexpr char kRefusedStart[] =
    "board {}: it refused to start a frame with {} packets and {} cache lines; its core takes 1 to "
    "{} packets, and a power of two of at most {} lines";
inline constexpr char kOutsideBank[] =
    "board {}: there are no words {} to {} of bank {}; the board has {} banks of {} words";
inline constexpr char kNoConfiguration[] =
    "configuration {}: there is no such configuration; name one of {}, or a file FILE.json or "
    "FILE.so";
inline constexpr char kConfigurationFolder[] =
    "configuration {}: this is a folder, but a configuration is a file; name one, such as the "
    "{} that dynrt specialise writes";
inline constexpr char kNoConfigurationFile[] = "configuration {}: there is no such file";
inline constexpr char kNotMade[] = "{}: {}";
inline constexpr char kNoScriptToMake[] =
    "{}: is made by {}, which is not there; the program needs the folder that it was built from";
inline constexpr char kNotALibrary[] =
    "configuration {}: the shared library is cut off; make it again with scripts/configuration";
inline constexpr char kNotLoaded[] = "configuration {}: cannot load it: {}";
inline constexpr char kForeignLibrary[] =
    "configuration {}: this shared library is not a configuration of dynrt; make one with "
    "scripts/configuration";
inline constexpr char kOtherBuild[] =
    "configuration {}: it was made from other sources or by another compiler than this program; "
    "make it again with scripts/configuration";
inline constexpr char kNoSchedulesOfLibrary[] =
    "configuration {}: a shared library does not say what its units are made from; name the JSON "
    "file that it was made from, and its units can be lowered";
inline constexpr char kNoBoard[] =
    "board {}: there is no such board; the boards are rtl, model, ulx3s and "
    "serial:DEVICE";
inline constexpr char kModelAlone[] =
    "configuration {}: it has only the native model, so it has no board rtl; take a configuration "
    "with Verilog ({}), or give it \"rtl\": true in hls/configs/configs.json and build again";
inline constexpr char kWideWords[] =
    "configuration {}: a float of {} bits needs memory words of {} bits, but the SRAM of board rtl "
    "has words of {}; take board model";
inline constexpr char kNoRtl[] =
    "board rtl: the Verilog of configuration {} is not part of this build; configure with "
    "-DDYNRT_RTL=ON or take board model";
inline constexpr char kNoTrace[] =
    "waveforms: only board rtl has signals to record; take board rtl or leave the waveforms out";
inline constexpr char kScheduleOfRtl[] =
    "schedules: only board model counts its clocks with schedules, as the Verilog has clocks of "
    "its own; take board model or leave the schedules out";
inline constexpr char kNoSchedule[] =
    "{}: the folder has no schedules of hlsc; name the folder of a configuration's Verilog, such "
    "as build/release/generated/fast";
inline constexpr char kBadSchedule[] =
    "{}: not a complete schedule of hlsc; lower the unit again or remove the file";
inline constexpr char kIncompleteSchedule[] =
    "{}: {} of configuration {}; name the folder of that configuration's Verilog";
inline constexpr char kScanWords[] =
    "board {}: it has {} registers for its scan-out, but the host writes {}; rebuild the Verilog "
    "and the host together";
inline constexpr char kNoScanOut[] =
    "board {} of configuration {} has no scan-out; take board rtl and a configuration with the key "
    "scan_out, such as thesis";
inline constexpr char kDisplaySize[] =
    "a picture of {}x{} does not fit the display of {}x{}; render a smaller one";
inline constexpr char kDisplayPitch[] =
    "a display shows rows that follow each other, and those of configuration {} begin {} pixels "
    "apart where {} are rendered; render a picture whose width is a multiple of {}";
inline constexpr char kTrace[] =
    "{}: cannot write this file; name a file in a folder that can be written";

}  // namespace dynrt::host::messages
