// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A small unit that has a port of every kind, for the tests of the files that are written.
#pragma once

#include <string>

#include "backend.h"
#include "netlist/builder.h"

namespace hlsc {

/// Adds a token to its row's total, scaled, and to its row's sum as it is, and counts.
inline Netlist example() {
  Netlist n;
  Builder b(n);
  n.module = "example";
  n.unit = "Example<4>";
  n.source = "units/example.h";
  const auto port = [&n](PortKind kind, const char* name, unsigned width, unsigned rows = 1,
                         unsigned latency = 0) {
    n.ports.push_back({kind, name, width, rows, latency, {"units/example.h", 20}});
    return static_cast<unsigned>(n.ports.size() - 1);
  };
  const unsigned sample = port(PortKind::kIn, "sample", 14);
  const unsigned scale = port(PortKind::kConfig, "scale", 8);
  const unsigned total = port(PortKind::kOut, "total", 16);
  const unsigned alarm = port(PortKind::kOut, "alarm", 1);
  const unsigned totals = port(PortKind::kRam, "totals", 16, 16, 1);
  const unsigned limit = port(PortKind::kRamRead, "limit", 16, 16, 1);
  const unsigned last = port(PortKind::kRamWrite, "last", 8, 16, 1);
  const unsigned sums = port(PortKind::kRegisterFile, "sums", 8, 16);
  n.registers.push_back({"count", 8, Bits(8, 3), kNoNode, {"units/example.h", 27}});

  const NodeId yes = b.constant(1, 1);
  const NodeId row = b.source(Op::kToken, sample, 0, 4);
  const NodeId value = b.source(Op::kToken, sample, 4, 8);
  b.name(value, "value");
  n.row_reads.push_back({totals, yes, row});
  n.row_reads.push_back({limit, yes, row});
  const NodeId before = b.source(Op::kRow, 0, 0, 16);
  const NodeId most = b.source(Op::kRow, 1, 0, 16);
  b.set_line({"units/example.h", 32});
  const NodeId product = b.mul(b.zext(value, 16), b.zext(b.source(Op::kConfig, scale, 0, 8), 16));
  b.set_line({"units/example.h", 33});
  const NodeId after = b.add(before, product);
  b.name(after, "after");
  const NodeId above = b.less(Op::kULt, most, after);
  const NodeId count = b.source(Op::kRegister, 0, 0, 8);
  n.registers[0].next = b.add(count, b.zext(b.source(Op::kToken, sample, 12, 1), 8));
  n.row_writes.push_back({totals, yes, row, after});
  n.row_writes.push_back({last, yes, row, value});
  n.row_reads.push_back({sums, yes, row});
  n.row_writes.push_back({sums, yes, row, b.add(b.source(Op::kRow, 2, 0, 8), value)});
  n.token_writes.push_back({total, yes, after});
  n.token_writes.push_back({alarm, above, b.slice(count, 7, 1)});
  check(n);
  return n;
}

inline Options options() {
  Options o;
  o.clock_ns = 10;
  o.delay = load_delay_model(std::string(DELAY_FOLDER) + "/ecp5.json");
  return o;
}

}  // namespace hlsc
