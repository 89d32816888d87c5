// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "netlist/narrow.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "error.h"
#include "netlist/builder.h"
#include "netlist/narrow_messages.h"

namespace hlsc {
namespace {

/// For every node the number of its low bits that are looked at; 0 where none is.
class Demand {
 public:
  explicit Demand(const Netlist& netlist) : net_(netlist), low_(netlist.nodes.size(), 0) {
    std::vector<bool> fetched(net_.row_reads.size(), false);
    const auto whole = [&](NodeId id) { need(id, net_.nodes[id].width); };
    for (const TokenWrite& write : net_.token_writes) {
      whole(write.enable);
      whole(write.data);
    }
    for (const RowWrite& write : net_.row_writes) {
      whole(write.enable);
      whole(write.address);
      whole(write.data);
    }
    for (const Register& state : net_.registers) {
      if (state.next != kNoNode) need(state.next, state.width);
    }
    // Rows come from their read's address and enable, which have lower or higher numbers.
    for (bool changed = true; changed;) {
      for (std::size_t id = net_.nodes.size(); id-- > 0;) visit(net_.nodes[id], low_[id]);
      changed = false;
      for (std::size_t id = 0; id < net_.nodes.size(); ++id) {
        const Node& node = net_.nodes[id];
        if (node.op != Op::kRow || low_[id] == 0 || fetched[node.port]) continue;
        fetched[node.port] = changed = true;
        whole(net_.row_reads[node.port].enable);
        whole(net_.row_reads[node.port].address);
      }
    }
  }

  unsigned of(NodeId id) const { return low_[id]; }

 private:
  void need(NodeId id, unsigned bits) {
    low_[id] = std::max(low_[id], std::min(bits, net_.nodes[id].width));
  }

  void visit(const Node& node, unsigned bits) {
    if (bits == 0) return;
    switch (node.op) {
      case Op::kAdd:
      case Op::kSub:
      case Op::kMul:
      case Op::kAnd:
      case Op::kOr:
      case Op::kXor:
      case Op::kNot:
      case Op::kSExt:
        for (NodeId operand : node.operands) need(operand, bits);
        return;
      case Op::kAddSub:
        need(node.operands[0], bits);
        need(node.operands[1], bits);
        need(node.operands[2], 1);
        return;
      case Op::kShl:
        need(node.operands[0], bits);
        need(node.operands[1], ~0u);
        return;
      case Op::kMux:
        need(node.operands[0], 1);
        need(node.operands[1], bits);
        need(node.operands[2], bits);
        return;
      case Op::kSlice:
        need(node.operands[0], node.low + bits);
        return;
      case Op::kConcat: {
        unsigned low = 0;
        for (auto operand = node.operands.rbegin(); operand != node.operands.rend(); ++operand) {
          if (low < bits) need(*operand, bits - low);
          low += net_.nodes[*operand].width;
        }
        return;
      }
      default:
        for (NodeId operand : node.operands) need(operand, ~0u);
        return;
    }
  }

  const Netlist& net_;
  std::vector<unsigned> low_;
};

/// Copies a netlist through a builder, each node cut to its demand.
class Rebuild {
 public:
  Rebuild(const Netlist& from, const std::map<unsigned, unsigned>& register_active)
      : from_(from), demand_(from), builder_(to_), made_(from.nodes.size(), kNoNode) {
    to_.module = from.module;
    to_.unit = from.unit;
    to_.source = from.source;
    to_.ports = from.ports;
    to_.registers = from.registers;
    for (Register& state : to_.registers) state.next = kNoNode;
    for (const auto& [index, active] : register_active) builder_.assume_register(index, active);
  }

  Netlist run() {
    number_row_reads();
    for (NodeId id = 0; id < from_.nodes.size(); ++id) {
      if (demand_.of(id) > 0) visit(id);
    }
    for (const TokenWrite& w : from_.token_writes) {
      if (is_never(w.enable)) continue;
      to_.token_writes.push_back({w.port, made_[w.enable], made_[w.data]});
    }
    for (const RowWrite& w : from_.row_writes) {
      if (is_never(w.enable)) continue;
      to_.row_writes.push_back({w.port, made_[w.enable], made_[w.address], made_[w.data]});
    }
    for (std::size_t i = 0; i < from_.registers.size(); ++i) {
      const NodeId next = from_.registers[i].next;
      if (next == kNoNode) continue;
      const NodeId made = builder_.zext(made_[next], to_.registers[i].width);
      if (made != register_node(static_cast<unsigned>(i))) to_.registers[i].next = made;
    }
    for (const auto& [old_number, number] : read_number_) {
      const RowRead& read = from_.row_reads[old_number];
      to_.row_reads[number] = {read.port, made_[read.enable], made_[read.address]};
    }
    return std::move(to_);
  }

  unsigned active_bits(NodeId id) const { return builder_.active_bits(id); }

 private:
  void number_row_reads() {
    for (NodeId id = 0; id < from_.nodes.size(); ++id) {
      const Node& node = from_.nodes[id];
      if (node.op == Op::kRow && demand_.of(id) > 0) read_number_.emplace(node.port, 0);
    }
    unsigned number = 0;
    for (auto& entry : read_number_) entry.second = number++;
    to_.row_reads.resize(number);
  }

  /// Makes a node after all that it needs; a row needs its address and its enable.
  void visit(NodeId id) {
    if (made_[id] != kNoNode) return;
    const Node& node = from_.nodes[id];
    if (node.op == Op::kRow) {
      const RowRead& read = from_.row_reads[node.port];
      if (!rows_begun_.insert(id).second) {
        const Port& port = from_.ports[read.port];
        throw Error(node.where, fmt::format(messages::kRowAddress, port.name));
      }
      visit(read.enable);
      visit(read.address);
    }
    for (NodeId operand : node.operands) {
      if (demand_.of(operand) > 0) visit(operand);
    }
    builder_.set_line(node.where);
    made_[id] = rebuild(node, demand_.of(id));
    if (!node.name.empty()) builder_.name(made_[id], node.name);
  }

  NodeId register_node(unsigned index) {
    return builder_.source(Op::kRegister, index, 0, to_.registers[index].width);
  }

  bool is_never(NodeId old_enable) const {
    const Node& enable = to_.nodes[made_[old_enable]];
    return enable.op == Op::kConst && enable.value.is_zero();
  }

  /// The low `bits` of an operand's new node; of a narrower one nobody looks at the rest.
  NodeId operand(const Node& node, unsigned index, unsigned bits) {
    const NodeId made = made_[node.operands[index]];
    return builder_.width(made) >= bits ? builder_.trunc(made, bits) : builder_.zext(made, bits);
  }
  NodeId whole(const Node& node, unsigned index) {
    return operand(node, index, from_.nodes[node.operands[index]].width);
  }

  NodeId rebuild(const Node& node, unsigned bits) {
    switch (node.op) {
      case Op::kConst:
        return builder_.constant(to_apint(node.value).trunc(bits));
      case Op::kToken:
      case Op::kConfig:
        return builder_.source(node.op, node.port, node.low, bits);
      case Op::kRow:
        return builder_.source(node.op, read_number_.at(node.port), node.low, bits);
      case Op::kRegister:
        return builder_.zext(register_node(node.port), bits);
      case Op::kAdd:
        return builder_.add(operand(node, 0, bits), operand(node, 1, bits));
      case Op::kSub:
        return builder_.sub(operand(node, 0, bits), operand(node, 1, bits));
      case Op::kMul:
        return builder_.mul(operand(node, 0, bits), operand(node, 1, bits));
      case Op::kAnd:
      case Op::kOr:
      case Op::kXor:
        return builder_.logic(node.op, operand(node, 0, bits), operand(node, 1, bits));
      case Op::kNot:
        return builder_.invert(operand(node, 0, bits));
      case Op::kMux:
        return builder_.mux(operand(node, 0, 1), operand(node, 1, bits), operand(node, 2, bits));
      case Op::kShl:
        return builder_.shift(node.op, operand(node, 0, bits), whole(node, 1));
      case Op::kSlice:
        return builder_.slice(operand(node, 0, node.low + bits), node.low, bits);
      case Op::kSExt: {
        const unsigned inner = from_.nodes[node.operands[0]].width;
        return builder_.sext(operand(node, 0, std::min(bits, inner)), bits);
      }
      case Op::kConcat:
        return rebuild_concat(node, bits);
      case Op::kAddSub:
        throw std::logic_error("add-subtract nodes are made after the front end");
      default:
        return builder_.trunc(rebuild_whole(node), bits);
    }
  }

  NodeId rebuild_whole(const Node& node) {
    switch (node.op) {
      case Op::kUDiv:
        return builder_.udiv(whole(node, 0), whole(node, 1));
      case Op::kLShr:
      case Op::kAShr:
        return builder_.shift(node.op, whole(node, 0), whole(node, 1));
      case Op::kEq:
        return builder_.equal(whole(node, 0), whole(node, 1));
      case Op::kULt:
      case Op::kSLt:
        return builder_.less(node.op, whole(node, 0), whole(node, 1));
      default:
        return builder_.clz(whole(node, 0), node.width);
    }
  }

  NodeId rebuild_concat(const Node& node, unsigned bits) {
    std::vector<NodeId> parts;
    unsigned low = 0;
    for (std::size_t i = node.operands.size(); i-- > 0 && low < bits;) {
      const unsigned width = std::min(from_.nodes[node.operands[i]].width, bits - low);
      parts.insert(parts.begin(), operand(node, static_cast<unsigned>(i), width));
      low += width;
    }
    return builder_.concat(parts);
  }

  const Netlist& from_;
  Demand demand_;
  Netlist to_;
  Builder builder_;
  std::vector<NodeId> made_;
  std::map<unsigned, unsigned> read_number_;
  std::set<NodeId> rows_begun_;
};

/// The bits that each register's value needs: first those of its reset value, then more until the
/// register's next values fit.
std::map<unsigned, unsigned> active_register_bits(const Netlist& netlist) {
  constexpr unsigned kRounds = 4;
  std::map<unsigned, unsigned> active;
  for (unsigned i = 0; i < netlist.registers.size(); ++i) {
    active[i] = std::max(1u, to_apint(netlist.registers[i].reset).getActiveBits());
  }
  for (unsigned round = 0;; ++round) {
    Rebuild trial(netlist, active);
    const Netlist result = trial.run();
    bool grown = false;
    for (unsigned i = 0; i < result.registers.size(); ++i) {
      const NodeId next = result.registers[i].next;
      const unsigned needed = next == kNoNode ? 1 : std::max(1u, trial.active_bits(next));
      if (needed <= active[i]) continue;
      active[i] = round < kRounds ? needed : netlist.registers[i].width;
      grown = true;
    }
    if (!grown) return active;
  }
}

void cut_registers(Netlist& netlist, const std::map<unsigned, unsigned>& active) {
  // The register nodes keep their width until the next rebuild, which sees slices of them only.
  for (const auto& [index, bits] : active) {
    Register& state = netlist.registers[index];
    if (bits >= state.width) continue;
    state.width = bits;
    state.reset = to_bits(to_apint(state.reset).trunc(bits));
  }
}

/// Leaves out the nodes that nobody looks at: rebuilding makes some on its way.
Netlist without_unused(const Netlist& netlist) {
  const Demand demand(netlist);
  Netlist kept = netlist;
  kept.nodes.clear();
  kept.row_reads.clear();
  std::vector<NodeId> place(netlist.nodes.size(), kNoNode);
  std::map<unsigned, unsigned> read_number;
  for (NodeId id = 0; id < netlist.nodes.size(); ++id) {
    const Node& node = netlist.nodes[id];
    if (demand.of(id) == 0 || node.op != Op::kRow || read_number.contains(node.port)) continue;
    read_number.emplace(node.port, static_cast<unsigned>(kept.row_reads.size()));
    kept.row_reads.push_back(netlist.row_reads[node.port]);
  }
  for (NodeId id = 0; id < netlist.nodes.size(); ++id) {
    if (demand.of(id) == 0) continue;
    Node node = netlist.nodes[id];
    for (NodeId& operand : node.operands) operand = place[operand];
    if (node.op == Op::kRow) node.port = read_number.at(node.port);
    place[id] = kept.add(std::move(node));
  }
  const auto follow = [&](NodeId& id) { id = place[id]; };
  for (TokenWrite& w : kept.token_writes) follow(w.enable), follow(w.data);
  for (RowRead& r : kept.row_reads) follow(r.enable), follow(r.address);
  for (RowWrite& w : kept.row_writes) follow(w.enable), follow(w.address), follow(w.data);
  for (Register& r : kept.registers) {
    if (r.next != kNoNode) follow(r.next);
  }
  return kept;
}

}  // namespace

Netlist narrow(const Netlist& netlist) {
  const auto active = active_register_bits(netlist);
  Netlist narrowed = Rebuild(netlist, active).run();
  cut_registers(narrowed, active);
  for (unsigned round = 0; round < 2; ++round) narrowed = Rebuild(narrowed, {}).run();
  return without_unused(narrowed);
}

}  // namespace hlsc
