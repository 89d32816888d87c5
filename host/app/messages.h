// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the program itself says when something is wrong.
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
inline constexpr char kBeyondMargin[] =
    "object '{}'{}: small for the scene; rays that start many times its size away from it may pass "
    "it at an edge in a plane of its tree, though it is tested watertight";
