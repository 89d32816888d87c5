// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The start of a frame: the numbers that the core and all that start it must agree on. The Verilog
// has them from dynrt_core.vh, which elaborate.cpp writes.
#pragma once

namespace dynrt {

/// Clocks that the board resets the core before a frame: a reset clears a row of every register
/// file a clock, and they have a row for each packet.
inline constexpr unsigned kResetClocks = 64;
/// Clocks after its reset in which the core takes no token yet: its units have the reset from
/// registers of the join.
inline constexpr unsigned kResetRegister = 1;
/// Start tokens below are the numbers of cache lines, which become empty; from it on, of packets,
/// which become free.
inline constexpr unsigned kFirstPacket = 1u << 9;
/// Clocks that the board waits between lines and packets: the caches are empty by then.
inline constexpr unsigned kStartPause = 64;

}  // namespace dynrt
