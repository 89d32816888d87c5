// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The parts of hlsc's schedules that a simulation of clocks needs.
#pragma once

#include <map>
#include <string>

namespace hls {

struct ModuleSchedule {
  /// Clocks from a transaction's start to its tokens at the head of their FIFOs.
  unsigned stages = 1;
  /// A transaction starts only while fewer tokens than these wait in the FIFO of each output, if
  /// the join does not say how many there can be at most.
  unsigned room = 1;
  /// The stage that reads or writes a RAM between units, by the port's name.
  std::map<std::string, unsigned> ram_stages = {};
};

/// By the modules' names.
using ModuleSchedules = std::map<std::string, ModuleSchedule>;

}  // namespace hls
