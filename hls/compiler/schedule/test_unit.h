// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Units and a delay model whose times can be added up by hand, for the tests of the schedule.
#pragma once

#include "netlist/builder.h"
#include "schedule/delay_model.h"

namespace hlsc {

/// Round numbers: a LUT takes 1 ns, a carry chain 1 and 0.1 for each bit, tokens come at once.
inline DelayModel round_numbers() {
  DelayModel d;
  d.name = "round numbers";
  d.lut = 1;
  d.carry_start = 1;
  d.carry_bit = 0.1;
  d.compare_out = 1;
  d.multiply = 3;
  d.block_register = 0.5;
  d.ram_out = 2;
  d.lut_ram = 1;
  return d;
}

struct Unit {
  Netlist n;
  Builder b{n};

  explicit Unit(unsigned width) { port(PortKind::kIn, "in", width); }
  unsigned port(PortKind kind, const char* name, unsigned width, unsigned rows = 1,
                unsigned latency = 0) {
    n.ports.push_back({kind, name, width, rows, latency, {"unit.h", 7}});
    return static_cast<unsigned>(n.ports.size() - 1);
  }
  NodeId in(unsigned low, unsigned width) { return b.source(Op::kToken, 0, low, width); }
  void out(NodeId data, const char* name = "out") {
    n.token_writes.push_back({port(PortKind::kOut, name, b.width(data)), b.constant(1, 1), data});
  }
  NodeId read(unsigned port, NodeId address) {
    n.row_reads.push_back({port, b.constant(1, 1), address});
    return b.source(Op::kRow, static_cast<unsigned>(n.row_reads.size() - 1), 0,
                    n.ports[port].width);
  }
  void write(unsigned port, NodeId address, NodeId data) {
    n.row_writes.push_back({port, b.constant(1, 1), address, data});
  }
};

}  // namespace hlsc
