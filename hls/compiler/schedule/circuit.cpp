// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "schedule/circuit.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "netlist/op.h"

namespace hlsc {
namespace {

/// Nodes that something written depends on.
std::vector<bool> find_live(const Netlist& n) {
  std::vector<bool> live(n.nodes.size(), false);
  const auto mark = [&live](NodeId id) {
    if (id != kNoNode) live[id] = true;
  };
  for (const TokenWrite& w : n.token_writes) mark(w.enable), mark(w.data);
  for (const RowWrite& w : n.row_writes) mark(w.enable), mark(w.address), mark(w.data);
  for (const Register& r : n.registers) mark(r.next);
  // A row read lives if one of its rows does, which come after its address.
  for (NodeId id = static_cast<NodeId>(n.nodes.size()); id-- > 0;) {
    if (!live[id]) continue;
    const Node& node = n.nodes[id];
    for (const NodeId operand : node.operands) mark(operand);
    if (node.op == Op::kRow) {
      mark(n.row_reads[node.port].address);
      mark(n.row_reads[node.port].enable);
    }
  }
  return live;
}

class CircuitBuilder {
 public:
  CircuitBuilder(const Netlist& netlist, Circuit& circuit)
      : n_(netlist), c_(circuit), live_(find_live(netlist)), bits_(netlist.nodes.size()) {}

  void run() {
    c_.row_read.assign(n_.row_reads.size(), BitRef::kConstant);
    c_.register_read.assign(n_.registers.size(), BitRef::kConstant);
    c_.register_write.assign(n_.registers.size(), BitRef::kConstant);
    find_fields();
    for (NodeId id = 0; id < n_.nodes.size(); ++id) {
      if (live_[id]) visit(id);
    }
    for (unsigned i = 0; i < n_.registers.size(); ++i) {
      const Register& r = n_.registers[i];
      // A register that nothing reads needs no next value.
      if (r.next == kNoNode || c_.register_read[i] == BitRef::kConstant) continue;
      c_.register_write[i] = sink(CellKind::kRegisterWrite, i, {r.next});
    }
    for (unsigned i = 0; i < n_.row_writes.size(); ++i) {
      const RowWrite& w = n_.row_writes[i];
      sink(CellKind::kRowWrite, i, {w.enable, w.address, w.data});
    }
    for (unsigned i = 0; i < n_.token_writes.size(); ++i) {
      sink(CellKind::kTokenWrite, i, {n_.token_writes[i].enable, n_.token_writes[i].data});
    }
    for (const Cell& cell : c_.cells) c_.still.push_back(cell.kind == CellKind::kConfig);
    c_.users.resize(c_.cells.size());
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      const Cell& cell = c_.cells[id];
      if (cell.kind == CellKind::kRow && c_.port_of(id).kind == PortKind::kRegisterFile) {
        c_.users[c_.row_read[cell.index]].push_back(id);
      }
      for (const auto& operand : cell.operands) {
        for (const BitRef& b : operand) {
          if (b.is_constant()) continue;
          auto& users = c_.users[b.cell];
          if (users.empty() || users.back() != id) users.push_back(id);
        }
      }
    }
  }

 private:
  using Key = std::pair<Op, unsigned>;  ///< kind of source and its number

  /// Cuts every token, row and value where a node's range begins or ends.
  void find_fields() {
    for (NodeId id = 0; id < n_.nodes.size(); ++id) {
      const Node& n = n_.nodes[id];
      if (!live_[id] || !is_source(n.op) || n.op == Op::kConst || n.op == Op::kRegister) continue;
      cuts_[{n.op, n.port}].insert({n.low, n.low + n.width});
    }
  }

  CellId push(Cell cell) {
    cell.first_bit = c_.bits;
    c_.bits += cell.width;
    c_.cells.push_back(std::move(cell));
    return static_cast<CellId>(c_.cells.size() - 1);
  }

  CellId sink(CellKind kind, unsigned index, const std::vector<NodeId>& operands) {
    Cell cell;
    cell.kind = kind;
    cell.index = index;
    for (const NodeId operand : operands) cell.operands.push_back(bits_[operand]);
    return push(std::move(cell));
  }

  CellId field(Op op, unsigned index, unsigned low, unsigned high, NodeId node) {
    const auto key = std::make_pair(Key{op, index}, low);
    const auto found = fields_.find(key);
    if (found != fields_.end()) {
      // The node that reads just this field has the best name.
      const Node& n = n_.nodes[node];
      if (n.low == low && n.width == high - low && !n.name.empty()) {
        c_.cells[found->second].node = node;
      }
      return found->second;
    }
    Cell cell;
    cell.kind = op == Op::kToken    ? CellKind::kToken
                : op == Op::kConfig ? CellKind::kConfig
                                    : CellKind::kRow;
    cell.index = index;
    cell.node = node;
    cell.low = low;
    cell.width = high - low;
    return fields_[key] = push(std::move(cell));
  }

  void visit_source(NodeId id) {
    const Node& n = n_.nodes[id];
    auto& bits = bits_[id];
    if (n.op == Op::kConst) {
      for (unsigned i = 0; i < n.width; ++i) {
        bits.push_back({BitRef::kConstant, n.value.bit(i) ? 1u : 0u});
      }
      return;
    }
    if (n.op == Op::kRegister) {
      CellId& cell = c_.register_read[n.port];
      if (cell == BitRef::kConstant) {
        Cell made;
        made.kind = CellKind::kRegister;
        made.index = n.port;
        made.node = id;
        made.width = n.width;
        cell = push(std::move(made));
      }
      append(bits, cell, 0, n.width);
      return;
    }
    if (n.op == Op::kRow && c_.row_read[n.port] == BitRef::kConstant) {
      const RowRead& read = n_.row_reads[n.port];
      c_.row_read[n.port] = sink(CellKind::kRowRead, n.port, {read.enable, read.address});
    }
    const std::set<unsigned>& cuts = cuts_.at({n.op, n.port});
    for (auto it = cuts.find(n.low); *it < n.low + n.width; ++it) {
      const unsigned high = *std::next(it);
      append(bits, field(n.op, n.port, *it, high, id), 0, high - *it);
    }
  }

  static void append(std::vector<BitRef>& bits, CellId cell, unsigned low, unsigned width) {
    for (unsigned i = 0; i < width; ++i) bits.push_back({cell, low + i});
  }

  void visit(NodeId id) {
    const Node& n = n_.nodes[id];
    auto& bits = bits_[id];
    if (is_source(n.op)) {
      visit_source(id);
    } else if (n.op == Op::kSlice) {
      const auto& from = bits_[n.operands[0]];
      bits.assign(from.begin() + n.low, from.begin() + n.low + n.width);
    } else if (n.op == Op::kConcat) {
      for (auto it = n.operands.rbegin(); it != n.operands.rend(); ++it) {
        bits.insert(bits.end(), bits_[*it].begin(), bits_[*it].end());
      }
    } else if (n.op == Op::kSExt) {
      bits = bits_[n.operands[0]];
      bits.resize(n.width, bits.back());
    } else {
      Cell cell;
      cell.node = id;
      cell.width = n.width;
      for (const NodeId operand : n.operands) cell.operands.push_back(bits_[operand]);
      append(bits, push(std::move(cell)), 0, n.width);
    }
  }

  const Netlist& n_;
  Circuit& c_;
  std::vector<bool> live_;
  std::vector<std::vector<BitRef>> bits_;  ///< of each node
  std::map<Key, std::set<unsigned>> cuts_;
  std::map<std::pair<Key, unsigned>, CellId> fields_;
};

}  // namespace

Circuit::Circuit(const Netlist& n) : netlist(n) { CircuitBuilder(n, *this).run(); }

const Port& Circuit::port_of(CellId id) const {
  const Cell& cell = cells[id];
  switch (cell.kind) {
    case CellKind::kToken:
    case CellKind::kConfig:
      return netlist.ports[cell.index];
    case CellKind::kRow:
    case CellKind::kRowRead:
      return netlist.ports[netlist.row_reads[cell.index].port];
    case CellKind::kRowWrite:
      return netlist.ports[netlist.row_writes[cell.index].port];
    case CellKind::kTokenWrite:
      return netlist.ports[netlist.token_writes[cell.index].port];
    default:
      throw std::logic_error("circuit: the cell has no port");
  }
}

SourceLine Circuit::where(CellId id) const {
  const Cell& cell = cells[id];
  switch (cell.kind) {
    case CellKind::kOperation:
      return netlist.nodes[cell.node].where;
    case CellKind::kRegister:
    case CellKind::kRegisterWrite:
      return netlist.registers[cell.index].where;
    default:
      return port_of(id).where;
  }
}

std::string Circuit::describe(CellId id) const {
  const Cell& cell = cells[id];
  switch (cell.kind) {
    case CellKind::kOperation: {
      const Node& n = netlist.nodes[cell.node];
      const std::string what = op_name(n.op) + std::string(" of ") + std::to_string(n.width) +
                               (n.width == 1 ? " bit" : " bits");
      return n.name.empty() ? what : "'" + n.name + "' (" + what + ")";
    }
    case CellKind::kRegister:
      return "register '" + netlist.registers[cell.index].name + "'";
    case CellKind::kRegisterWrite:
      return "the next value of register '" + netlist.registers[cell.index].name + "'";
    case CellKind::kRow:
      return "the row of '" + port_of(id).name + "'";
    case CellKind::kRowRead:
      return "the read of '" + port_of(id).name + "'";
    case CellKind::kRowWrite:
    case CellKind::kTokenWrite:
      return "the write to '" + port_of(id).name + "'";
    default:
      return "'" + port_of(id).name + "'";
  }
}

}  // namespace hlsc
