// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "emit/emit.h"
#include "hls/json_text.h"

namespace hlsc {

namespace {

/// The margin of the FIFOs (rtl/lib/hls_fifo.v): tokens that may be in the pipeline.
unsigned in_pipeline(const Schedule& schedule) {
  return static_cast<unsigned>(schedule.stages) - 1;
}

}  // namespace

unsigned fifo_depth(const Schedule& schedule, unsigned room) {
  unsigned depth = 1;
  while (depth < in_pipeline(schedule) + room) depth *= 2;
  return depth;
}

std::string emit_schedule(const Circuit& c, const Schedule& schedule, const Options& options) {
  using Json = nlohmann::ordered_json;
  Json rams = Json::object();
  for (CellId id = 0; id < c.cells.size(); ++id) {
    const CellKind kind = c.cells[id].kind;
    if (kind != CellKind::kRowRead && kind != CellKind::kRowWrite) continue;
    const Port& port = c.port_of(id);
    if (port.kind == PortKind::kRamRead || port.kind == PortKind::kRamWrite) {
      rams[port.name] = schedule.stage[id];
    }
  }
  const Json json = {{"unit", c.netlist.unit},
                     {"module", c.netlist.module},
                     {"clock_ns", options.clock_ns},
                     {"device", options.delay.name},
                     {"stages", schedule.stages},
                     {"room", fifo_depth(schedule, options.room) - in_pipeline(schedule)},
                     {"ram_stages", rams}};
  return hls::json_text(json);
}

}  // namespace hlsc
