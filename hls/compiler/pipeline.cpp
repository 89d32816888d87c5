// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The order of the lowering.
#include "backend.h"
#include "emit/emit.h"
#include "netlist/narrow.h"
#include "passes/passes.h"
#include "schedule/schedule.h"

namespace hlsc {

Netlist optimise(const Netlist& netlist, const Options& options) {
  Netlist n = narrow(netlist);
  n = balance_chains(n);
  n = expand_divisions(n, options.delay);
  n = split_products(n, options.delay);
  n = expand_shifts(n);
  n = narrow(n);
  n = merge_add_sub(n);
  return n;
}

Lowered lower(const Netlist& netlist, const Options& options) {
  check(netlist);
  const Netlist optimised = optimise(netlist, options);
  check(optimised);
  const Circuit circuit(optimised);
  const Schedule asap = schedule_asap(circuit, options.delay, options.clock_ns);
  const Schedule schedule = minimise_registers(circuit, options.delay, options.clock_ns, asap);
  Lowered lowered;
  lowered.verilog = emit_verilog(circuit, schedule, options);
  lowered.report = emit_report(circuit, schedule, options);
  lowered.schedule = emit_schedule(circuit, schedule, options);
  lowered.binding = emit_binding(netlist);
  lowered.latency = static_cast<unsigned>(schedule.stages);
  return lowered;
}

}  // namespace hlsc
