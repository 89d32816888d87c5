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
namespace {

struct Pass {
  const char* name;
  Netlist (*run)(const Netlist&, const DelayModel&);
};

constexpr Pass kPasses[] = {
    {"narrow", [](const Netlist& n, const DelayModel&) { return narrow(n); }},
    {"balance_chains", [](const Netlist& n, const DelayModel&) { return balance_chains(n); }},
    {"expand_divisions", expand_divisions},
    {"split_products", split_products},
    {"expand_shifts", [](const Netlist& n, const DelayModel&) { return expand_shifts(n); }},
    {"narrow", [](const Netlist& n, const DelayModel&) { return narrow(n); }},
    {"merge_add_sub", [](const Netlist& n, const DelayModel&) { return merge_add_sub(n); }},
};

/// What a schedule counts with. Reports and predictions count with the model itself.
DelayModel scheduling_model(const Options& options) {
  DelayModel delay = options.delay;
  delay.clock_overhead += options.uncertainty_ns;
  return delay;
}

}  // namespace

std::vector<std::string> netlist_passes() {
  std::vector<std::string> names;
  for (const Pass& pass : kPasses) names.emplace_back(pass.name);
  return names;
}

Netlist optimise(const Netlist& netlist, const Options& options, const PassObserver& observer) {
  Netlist n = netlist;
  for (const Pass& pass : kPasses) {
    n = pass.run(n, options.delay);
    if (observer) observer(pass.name, n);
  }
  return n;
}

double least_period(const Netlist& netlist, const Options& options) {
  check(netlist);
  const Netlist optimised = optimise(netlist, options);
  return least_period(Circuit(optimised), scheduling_model(options), 0);
}

Lowered lower(const Netlist& netlist, const Options& options) {
  check(netlist);
  const Netlist optimised = optimise(netlist, options);
  check(optimised);
  Circuit circuit(optimised);
  const DelayModel delay = scheduling_model(options);
  mark_still(circuit, delay, options.clock_ns);
  const double tight = tightest_period(circuit, delay, options.clock_ns);
  const Schedule asap = schedule_asap(circuit, delay, tight);
  const Schedule schedule = minimise_registers(circuit, delay, tight, asap);
  check_schedule({circuit, delay, tight, options.clock_ns}, schedule);
  Lowered lowered;
  lowered.verilog = emit_verilog(circuit, schedule, options);
  lowered.report = emit_report(circuit, schedule, options);
  lowered.schedule = emit_schedule(circuit, schedule, options);
  lowered.timing = emit_timing(circuit, schedule, options);
  lowered.binding = emit_binding(netlist);
  lowered.latency = static_cast<unsigned>(schedule.stages);
  return lowered;
}

}  // namespace hlsc
