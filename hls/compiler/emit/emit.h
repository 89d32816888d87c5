// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The files that hlsc writes about a scheduled unit.
#pragma once

#include <string>

#include "backend.h"
#include "schedule/schedule.h"

namespace hlsc {

/// One Verilog-2005 module: ports, handshake, stage by stage its wires and registers, then the
/// instances of rtl/lib.
std::string emit_verilog(const Circuit& circuit, const Schedule& schedule, const Options& options);

/// Stages with their operations, register bits and longest path.
std::string emit_report(const Circuit& circuit, const Schedule& schedule, const Options& options);

/// The same as JSON, for a simulation of clocks (hls/native/hls/module_schedule.h).
std::string emit_schedule(const Circuit& circuit, const Schedule& schedule, const Options& options);

/// When each register and each port of a FIFO or RAM gets its value, by the schedule's delay model
/// and by those of `time_by`, as JSON.
std::string emit_timing(const Circuit& circuit, const Schedule& schedule, const Options& options);

/// Tokens that the FIFO of an output holds if the join gives no bound: a power of two, as many as
/// the pipeline and `room` more, at least.
unsigned fifo_depth(const Schedule& schedule, unsigned room);

/// C++ header with visit_ports_<module>(), through which a test bench reaches all ports.
std::string emit_binding(const Netlist& netlist);

}  // namespace hlsc
