// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// hlsc's back end: netlist in, Verilog module with its schedule report and test-bench header out.
// Free of LLVM. Throws Error (error.h) if a unit cannot be lowered for this clock.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "netlist/netlist.h"
#include "schedule/delay_model.h"

namespace hlsc {

/// Tokens that a FIFO takes beyond those in the pipeline, at least: so many keep a pipeline going
/// that nothing behind it holds up.
inline constexpr unsigned kLeastRoom = 4;

struct Options {
  double clock_ns = 10;
  DelayModel delay;
  unsigned room = kLeastRoom;         ///< the same for this unit
  double uncertainty_ns = 0;          ///< of each clock, left to wires that the model does not know
  std::vector<DelayModel> time_by{};  ///< further models that time the schedule, not make it
};

struct Lowered {
  std::string verilog;
  std::string report;    ///< stages, operations and register bits per stage
  std::string schedule;  ///< the report for programs, as JSON
  std::string timing;    ///< when each register and each write gets its value, as JSON
  std::string binding;   ///< C++ header: visit_ports_<module>()
  unsigned latency = 0;  ///< clocks from a transaction's start to its tokens leaving
};

Lowered lower(const Netlist& netlist, const Options& options);

/// The least period for which a netlist can be lowered, in ns, whatever the options' period is.
double least_period(const Netlist& netlist, const Options& options);

/// Called after each pass with the pass's name and the netlist.
using PassObserver = std::function<void(const std::string& pass, const Netlist&)>;

/// The netlist after the passes, which is then scheduled.
Netlist optimise(const Netlist& netlist, const Options& options,
                 const PassObserver& observer = nullptr);

/// The passes of optimise() in their order; one that runs twice is there twice.
std::vector<std::string> netlist_passes();

}  // namespace hlsc
