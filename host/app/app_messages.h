// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the program itself.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kSizeText[] = "--size {}: write WIDTHxHEIGHT in pixels, for example 512x384";
inline constexpr char kPixelText[] =
    "--pixel {}: write the numbers of a pixel of this image, from 0,0 to {},{}";
inline constexpr char kPixelFlags[] =
    "--pixel {}: its hit record goes to the file of --json; name one and leave --no-hits out";
inline constexpr char kVectorText[] =
    "{} {}: write three numbers separated by commas, for example 1,2.5,-3";
inline constexpr char kVectorRange[] = "{} {}: the numbers must lie within -{:.3g} and {:.3g}";
inline constexpr char kCount[] = "{} is not a whole number from 0 to {}";
inline constexpr char kNumber[] = "{} is not a finite number";
inline constexpr char kStdout[] =
    "cannot print the report ({}); free some space or redirect the output to another place";
inline constexpr char kOrder[] = "--order {}: unknown; the orders are morton and scanline";
inline constexpr char kClock[] = "--clock {}: the clock is a number of MHz above zero";
inline constexpr char kNotPlacedOn[] =
    "--device {}: no core was placed on such a device, so it has no clock; those with a clock: {}";
inline constexpr char kNotPlacedOfGrade[] =
    "--grade {}: no core was placed on {} of this grade, so it has no clock; those with a clock: "
    "{}";
inline constexpr char kTimeoutZero[] = "--timeout 0: the board needs at least one clock";
inline constexpr char kTimeoutOfModel[] =
    "--timeout {}: board model has no clock that could run out; take board rtl or leave the "
    "timeout "
    "out";
inline constexpr char kLacksPrimitive[] =
    "--config {}: the configuration has no {}, but the scene '{}' contains them; these "
    "configurations have all that the scene needs: {}";
inline constexpr char kCommand[] =
    "{}: there is no such command; the commands are render, walk, compare, info, report, choose, "
    "measure, stress, needs, specialise and view";
inline constexpr char kNoReport[] =
    "report: name a report; the reports are overlap, mailbox, clipping, error, hardware and "
    "truth";
inline constexpr char kCountedSize[] =
    "--size {}x{}: dynrt counts work for packets of 2x2 rays, so both numbers must be even, above "
    "0 and at most {}";
inline constexpr char kNoScript[] =
    "{}: cannot run this script: {}; the program needs the source folder that it was built from";
inline constexpr char kUsage[] = "{}; dynrt {}--help lists what there is";
inline constexpr char kOrOnGeneral[] =
    "{}, or add --general-if-exceeded to render it on the general core";

// Light and mirrors
inline constexpr char kLightText[] =
    "--light {}: write X,Y,Z[:R,G,B[:INTENSITY]] with a colour that is neither negative nor black, "
    "and an intensity above zero, for example 1,3,2:1,0.9,0.8:5";
inline constexpr char kMirrorText[] =
    "--mirror {}: write MATERIAL[=PART] with a part from 0 to 1, for example chrome=0.9";
inline constexpr char kNoLightRays[] = "{}: configuration {} has no light rays; {}";
inline constexpr char kNoReflections[] = "{}: configuration {} has no reflected rays; {}";
inline constexpr char kLightsUnused[] =
    "the scene has {}, but configuration {} has no light rays and lights it from the eye; {}";
inline constexpr char kLightsTooMany[] =
    "the scene has {} lights, but configuration {} uses only the first {}";
inline constexpr char kMirrorsUnused[] =
    "the scene has {}, but configuration {} has no reflected rays; {}";

// Stress cases
inline constexpr char kFormatText[] =
    "--format {}: write the bits of exponent and mantissa, for example 7,12";
inline constexpr char kFormatOfFile[] =
    "--format: --config {} is a file, which has its own format; name a configuration";
inline constexpr char kFormatNotListed[] = "--format: there is no configuration '{}'";

// Frames
inline constexpr char kDroppedPushes[] =
    "warning     {} pushes onto full stacks (of {} entries) were dropped: hits may be missing; "
    "use a configuration with deeper stacks, such as deep";

inline constexpr char kDisplayMissed[] =
    "warning     the display has waited for its memory and missed pixels since it shows pictures "
    "of this size; the frame itself is whole";
inline constexpr char kMemoryExists[] =
    "board {}: its memory exists and has its own clocks; leave {} out, or take board rtl or model";

inline constexpr char kNoHit[] =
    "no ray hits anything; the scene lies between ({:.4g}, {:.4g}, {:.4g}) and ({:.4g}, {:.4g}, "
    "{:.4g}), and this camera sees all of it: --position {:.4g},{:.4g},{:.4g} --look-at "
    "{:.4g},{:.4g},{:.4g}";

// The window
inline constexpr char kViewPort[] = "--port {}: a port is a number from 1 to {}";
inline constexpr char kFormatOfThisFile[] =
    "configuration {}: a file has its own number format; choose a listed configuration to change "
    "it";

// Walks
inline constexpr char kFrames[] = "--frames {}: a walk has 1 to {} frames";
inline constexpr char kTimes[] =
    "--from {} and --to {}: the walk must begin at 0 seconds or later and end after it begins";
inline constexpr char kWalkOut[] =
    "--out {}: a walk is written to a folder, as PNG files, or to a .gif file";
inline constexpr char kJsonInWalk[] =
    "--json {}: this file lies in the folder where the walk keeps its frames, {}; name a file in "
    "another folder";
inline constexpr char kLightLater[] = "{} (after {} seconds)";
inline constexpr char kOtherWalk[] =
    "{}: the folder holds frames of another walk, with {} '{}' where this walk has '{}'; name "
    "another --out, or give --again to replace them";
inline constexpr char kChangedScene[] =
    "{}: the folder holds frames of an older version of the scene; name another --out, or give "
    "--again to replace them";
inline constexpr char kNotOurFrames[] =
    "{}: the folder has a {} but no {}, so dynrt did not write it as a walk; name another --out, "
    "or give --again to replace its frames";
inline constexpr char kCannotList[] =
    "{}: cannot list the files of this folder: {}; name another --out";
inline constexpr char kCannotRemove[] = "{}: cannot remove this file: {}; name another --out";
inline constexpr char kCannotRead[] = "{}: cannot read this file: {}; name another --out";
inline constexpr char kBadManifest[] =
    "{}: a walk did not write this file ({}); name another --out, or give --again to start again";
inline constexpr char kOrbit[] =
    "neither the scene nor its camera moves, so the camera goes once round the scene's centre";

inline constexpr char kDefect[] = "defect in dynrt: {}";

inline constexpr char kHoldsAnother[] =
    "board {} can hold configuration {}, not {}; name what it holds, or nothing";
inline constexpr char kHasItsCore[] =
    "board {} has the core that its bitstream is made of, so --specialise has no use; take board "
    "rtl or model";
inline constexpr char kHasItsDisplay[] =
    "board {} has a display of its own, which --scan-out cannot see; leave it out, or take board "
    "rtl";
inline constexpr char kNoDeviceNamed[] =
    "board {}: it names no device; write one behind the colon, such as serial:/dev/ttyUSB0";
inline constexpr char kNoWaveforms[] = "board {} writes no waveforms; --board rtl does";
inline constexpr char kNoSchedules[] =
    "board {} has clocks of its own, so --schedule has no use; --board model counts by schedules";
inline constexpr char kBanksOfSram[] =
    "configuration {} reads its scene from banks of SRAM, not from a memory behind a port; take "
    "fast_port or another whose key memory is port";
inline constexpr char kNoLayoutAsked[] =
    "--config says how the memory is laid out that --memory or --registers write; give one of them";

}  // namespace dynrt::host::messages
