// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "netlist/interpret.h"

#include "netlist/evaluate.h"
#include "netlist/op.h"

namespace hlsc {

Interpreter::Interpreter(const Netlist& netlist) : netlist_(netlist) {
  for (unsigned i = 0; i < netlist.ports.size(); ++i) {
    const Port& p = netlist.ports[i];
    if (p.kind == PortKind::kConfig) config_[i] = Bits(p.width, 0);
    if (is_ram(p.kind)) rows_[i].assign(p.rows, Bits(p.width, 0));
  }
  for (const Register& r : netlist.registers) registers_.push_back(r.reset);
}

Bits Interpreter::value_of(NodeId id, const std::vector<Bits>& tokens) const {
  const Node& n = netlist_.nodes[id];
  switch (n.op) {
    case Op::kConst:
      return n.value;
    case Op::kToken:
      return extract(tokens[n.port], n.low, n.width);
    case Op::kConfig:
      return extract(config_.at(n.port), n.low, n.width);
    case Op::kRegister:
      return registers_[n.port];
    case Op::kRow: {
      const RowRead& read = netlist_.row_reads[n.port];
      const auto& rows = rows_.at(read.port);
      const std::uint64_t address = values_[read.address].low64();
      if (!values_[read.enable].bit(0) || address >= rows.size()) return Bits(n.width, 0);
      return extract(rows[address], n.low, n.width);
    }
    default: {
      std::vector<Bits> operands;
      for (const NodeId operand : n.operands) operands.push_back(values_[operand]);
      return evaluate(n, operands);
    }
  }
}

std::vector<std::optional<Bits>> Interpreter::step(const std::vector<Bits>& tokens) {
  values_.clear();
  for (NodeId id = 0; id < netlist_.nodes.size(); ++id) values_.push_back(value_of(id, tokens));
  written_rows_.clear();
  for (const RowWrite& w : netlist_.row_writes) {
    auto& rows = rows_.at(w.port);
    const std::uint64_t address = values_[w.address].low64();
    if (!values_[w.enable].bit(0) || address >= rows.size()) continue;
    rows[address] = values_[w.data];
    written_rows_.push_back({w.port, address, values_[w.data]});
  }
  for (unsigned i = 0; i < registers_.size(); ++i) {
    const NodeId next = netlist_.registers[i].next;
    if (next != kNoNode) registers_[i] = values_[next];
  }
  std::vector<std::optional<Bits>> written(netlist_.ports.size());
  for (const TokenWrite& w : netlist_.token_writes) {
    if (values_[w.enable].bit(0)) written[w.port] = values_[w.data];
  }
  return written;
}

}  // namespace hlsc
