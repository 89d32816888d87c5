// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The messages of the program itself.
#pragma once

namespace dynrt::host::messages {

inline constexpr char kSizeText[] = "--size {}: write WIDTHxHEIGHT in pixels, for example 512x384";
inline constexpr char kVectorText[] =
    "{} {}: write three numbers separated by commas, for example 1,2.5,-3";
inline constexpr char kVectorRange[] = "{} {}: the numbers must lie within -{:.3g} and {:.3g}";
inline constexpr char kCount[] = "{} is not a whole number from 0 to {}";
inline constexpr char kNumber[] = "{} is not a finite number";
inline constexpr char kStdout[] =
    "the report cannot be printed ({}); free some space or send it elsewhere";
inline constexpr char kOrder[] = "--order {}: unknown; the orders are morton and scanline";
inline constexpr char kClock[] = "--clock {}: the clock is a number of MHz above zero";
inline constexpr char kTimeoutZero[] = "--timeout 0: the board needs at least one clock";
inline constexpr char kNoPrimitive[] =
    "--config {}: has no {}, of which the scene '{}' is made; the configurations that have all it "
    "needs are: {}";
inline constexpr char kCommand[] =
    "{}: unknown; the commands are render, walk, compare, info, report, choose, "
    "measure, stress, needs and specialise";
inline constexpr char kNoReport[] =
    "report: which one is missing; the reports are overlap, mailbox, clipping, error and "
    "truth";
inline constexpr char kCountedSize[] =
    "--size {}x{}: work is counted for packets of 2x2 rays, so both must be even, above 0 and at "
    "most {}";
inline constexpr char kNoScript[] =
    "{}: cannot be run: {}; the program needs the folder that it was built from";
inline constexpr char kUsage[] = "{}; dynrt {}--help lists what there is";

// Light and mirrors
inline constexpr char kLightText[] =
    "--light {}: write X,Y,Z[:R,G,B[:INTENSITY]] with a colour that is not negative nor black and "
    "an intensity above zero, for example 1,3,2:1,0.9,0.8:5";
inline constexpr char kMirrorText[] =
    "--mirror {}: write MATERIAL[=PART] with a part from 0 to 1, for example chrome=0.9";
inline constexpr char kNoLightRays[] = "{}: configuration {} has no light rays; {}";
inline constexpr char kNoReflections[] = "{}: configuration {} has no reflected rays; {}";
inline constexpr char kLightsUnused[] =
    "the scene has {}, but configuration {} has no light rays and lights it from the eye; {}";
inline constexpr char kLightsTooMany[] =
    "the scene has {} lights, of which configuration {} lets only the first {} shine";
inline constexpr char kMirrorsUnused[] =
    "the scene has {}, but configuration {} has no reflected rays; {}";

// Frames
inline constexpr char kDroppedPushes[] =
    "warning     {} pushes onto full stacks (of {} entries in the top-level tree, {} in objects) "
    "were dropped: hits may be missing; use a configuration with deeper stacks, such as deep";

// Walks
inline constexpr char kFrames[] = "--frames {}: a walk has 1 to {} frames";
inline constexpr char kTimes[] =
    "--from {} and --to {}: the walk must begin at 0 seconds or later and end after it begins";
inline constexpr char kWalkOut[] =
    "--out {}: a walk is written to a folder, as PNG files, or to a .gif file";
inline constexpr char kJsonInWalk[] =
    "--json {}: lies where the walk keeps its frames, in {}; name a file elsewhere";
inline constexpr char kLightLater[] = "{} (after {} seconds)";
inline constexpr char kOtherWalk[] =
    "{}: holds frames of another walk, with {} '{}' where this one has '{}'; name another --out, "
    "or "
    "give --again to start again";
inline constexpr char kChangedScene[] =
    "{}: holds frames of the scene as it was before it was changed; name another --out, or give "
    "--again to start again";
inline constexpr char kNotOurFrames[] =
    "{}: has a {} but no {}, so these are no frames of a walk; name another --out, or give --again "
    "to replace them";
inline constexpr char kCannotList[] = "{}: its files cannot be listed: {}; name another --out";
inline constexpr char kCannotRemove[] = "{}: cannot be removed: {}; name another --out";
inline constexpr char kCannotRead[] = "{}: cannot be read: {}; name another --out";
inline constexpr char kBadManifest[] =
    "{}: is not what a walk leaves ({}); name another --out, or give --again to start again";
inline constexpr char kOrbit[] =
    "nothing moves in the scene, nor does its camera: it goes round the scene's centre once";

inline constexpr char kDefect[] = "defect in dynrt: {}";

}  // namespace dynrt::host::messages
