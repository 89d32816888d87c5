// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "netlist/names.h"
#include "netlist/netlist.h"

namespace hlsc {
namespace {

std::string hex(const Bits& bits) {
  std::string digits;
  for (unsigned low = 0; low < bits.width(); low += 4) {
    unsigned digit = 0;
    for (unsigned i = 0; i < 4 && low + i < bits.width(); ++i) {
      digit |= static_cast<unsigned>(bits.bit(low + i)) << i;
    }
    digits.insert(digits.begin(), "0123456789abcdef"[digit]);
  }
  return fmt::format("{}'h{}", bits.width(), digits);
}

std::string node_line(const Netlist& net, NodeId id) {
  const Node& node = net.nodes[id];
  std::string line = fmt::format("%{}: {} = {}", id, node.width, op_name(node.op));
  switch (node.op) {
    case Op::kConst:
      line += " " + hex(node.value);
      break;
    case Op::kToken:
    case Op::kConfig:
      line += fmt::format(" {}[{}+:{}]", net.ports[node.port].name, node.low, node.width);
      break;
    case Op::kRow:
      line += fmt::format(" {}[{}+:{}]", net.ports[net.row_reads[node.port].port].name, node.low,
                          node.width);
      break;
    case Op::kRegister:
      line += " " + net.registers[node.port].name;
      break;
    default:
      for (std::size_t i = 0; i < node.operands.size(); ++i) {
        line += fmt::format("{} %{}", i == 0 ? "" : ",", node.operands[i]);
      }
      if (node.op == Op::kSlice) line += fmt::format(" [{}+:{}]", node.low, node.width);
      break;
  }
  if (!node.name.empty()) line += " ; " + node.name;
  if (!node.where.file.empty()) {
    line +=
        fmt::format(" {} {}:{}", node.name.empty() ? ";" : "at", node.where.file, node.where.line);
  }
  return line + "\n";
}

}  // namespace

const char* op_name(Op op) {
  static constexpr const char* kNames[] = {
      "const", "token", "config", "register", "row",    "add",  "sub",  "addsub", "mul",
      "udiv",  "and",   "or",     "xor",      "not",    "shl",  "lshr", "ashr",   "eq",
      "ult",   "slt",   "mux",    "slice",    "concat", "sext", "clz"};
  return kNames[static_cast<unsigned>(op)];
}

const char* kind_name(PortKind kind) {
  static constexpr const char* kNames[] = {"in",        "out",      "ram",   "register_file",
                                           "ram_write", "ram_read", "config"};
  return kNames[static_cast<unsigned>(kind)];
}

std::string to_text(const Netlist& net) {
  std::string text = fmt::format("unit {} ({}) module {}\n", net.unit, net.source, net.module);
  for (const Port& port : net.ports) {
    text += fmt::format("port {} {} width {} rows {} latency {}{}\n", kind_name(port.kind),
                        port.name, port.width, port.rows, port.latency,
                        port.hazard == Hazard::kStale ? " stale" : "");
  }
  for (NodeId id = 0; id < net.nodes.size(); ++id) text += node_line(net, id);
  for (const RowRead& read : net.row_reads) {
    text += fmt::format("read {} enable %{} address %{}\n", net.ports[read.port].name, read.enable,
                        read.address);
  }
  for (const RowWrite& write : net.row_writes) {
    text += fmt::format("write {} enable %{} address %{} data %{}\n", net.ports[write.port].name,
                        write.enable, write.address, write.data);
  }
  for (const TokenWrite& write : net.token_writes) {
    text += fmt::format("write {} enable %{} data %{}\n", net.ports[write.port].name, write.enable,
                        write.data);
  }
  for (const Register& state : net.registers) {
    text += fmt::format("register {} width {} reset {}", state.name, state.width, hex(state.reset));
    if (state.next != kNoNode) text += fmt::format(" next %{}", state.next);
    text += "\n";
  }
  return text;
}

}  // namespace hlsc
