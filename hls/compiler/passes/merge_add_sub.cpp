// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <optional>
#include <set>

#include "passes/passes.h"

namespace hlsc {
namespace {

class MergeAddSub {
 public:
  explicit MergeAddSub(const Netlist& netlist)
      : n_(netlist), users_(netlist.nodes.size()), made_(netlist.nodes.size(), kNoNode) {}

  Netlist run() {
    find_users();
    for (NodeId id = 0; id < n_.nodes.size(); ++id) {
      if (n_.nodes[id].op == Op::kAdd) plan(id);
    }
    out_ = n_;
    out_.nodes.clear();
    for (NodeId id = 0; id < n_.nodes.size(); ++id) get(id);
    const auto follow = [this](NodeId& id) { id = made_[id]; };
    for (TokenWrite& w : out_.token_writes) follow(w.enable), follow(w.data);
    for (RowRead& r : out_.row_reads) follow(r.enable), follow(r.address);
    for (RowWrite& w : out_.row_writes) follow(w.enable), follow(w.address), follow(w.data);
    for (Register& r : out_.registers) {
      if (r.next != kNoNode) follow(r.next);
    }
    return std::move(out_);
  }

 private:
  /// value = s ? -y : y, or with `inverted` s ? y : -y.
  struct Negation {
    NodeId s;
    NodeId y;
    bool inverted;
  };
  /// How an addition becomes an addition or subtraction.
  struct Merge {
    NodeId other;  ///< what y is added to, `low` bits further up
    NodeId mux;
    unsigned low;
    Negation negation;
  };

  const Node& node(NodeId id) const { return n_.nodes[id]; }

  void find_users() {
    const auto use = [this](NodeId id) { users_[id].push_back(kNoNode); };
    for (NodeId id = 0; id < n_.nodes.size(); ++id) {
      for (const NodeId operand : node(id).operands) users_[operand].push_back(id);
    }
    for (const TokenWrite& w : n_.token_writes) use(w.enable), use(w.data);
    for (const RowRead& r : n_.row_reads) use(r.enable), use(r.address);
    for (const RowWrite& w : n_.row_writes) use(w.enable), use(w.address), use(w.data);
    for (const Register& r : n_.registers) {
      if (r.next != kNoNode) use(r.next);
    }
  }

  bool is_negation(NodeId id, NodeId of) const {
    const Node& n = node(id);
    if (n.op != Op::kSub || n.operands[1] != of) return false;
    const Node& zero = node(n.operands[0]);
    return zero.op == Op::kConst && zero.value.is_zero();
  }

  std::optional<Negation> negation(NodeId id) const {
    const Node& n = node(id);
    if (n.op != Op::kMux) return std::nullopt;
    const NodeId s = n.operands[0];
    const NodeId yes = n.operands[1];
    const NodeId no = n.operands[2];
    if (is_negation(yes, no)) return Negation{s, no, false};
    if (is_negation(no, yes)) return Negation{s, yes, true};
    return std::nullopt;
  }

  void plan(NodeId add) {
    for (const unsigned side : {0u, 1u}) {
      NodeId mux = node(add).operands[side];
      unsigned low = 0;
      const NodeId slice = mux;
      if (node(mux).op == Op::kSlice) {
        low = node(mux).low;
        mux = node(mux).operands[0];
      }
      const auto found = negation(mux);
      if (!found) continue;
      // Other users of the negation may only use bits that the sum does not change.
      bool only_here = slice == mux || users_[slice].size() == 1;
      for (const NodeId user : users_[mux]) {
        if (user == slice || (user == add && slice == mux)) continue;
        only_here = only_here && user != kNoNode && node(user).op == Op::kSlice &&
                    node(user).low + node(user).width <= low;
      }
      if (!only_here || depends(node(add).operands[1 - side], mux)) continue;
      merges_[add] = {node(add).operands[1 - side], mux, low, *found};
      low_bits_[mux] = add;
      return;
    }
  }

  bool depends(NodeId id, NodeId on) const {
    std::set<NodeId> open{id};
    while (!open.empty()) {
      const NodeId last = *open.rbegin();
      if (last < on) return false;
      if (last == on) return true;
      open.erase(last);
      open.insert(node(last).operands.begin(), node(last).operands.end());
      if (node(last).op == Op::kRow) {
        const RowRead& read = n_.row_reads[node(last).port];
        open.insert({read.enable, read.address});
      }
    }
    return false;
  }

  NodeId make(Op op, unsigned width, std::vector<NodeId> operands, const Node& like,
              unsigned low = 0) {
    Node made;
    made.op = op;
    made.width = width;
    made.operands = std::move(operands);
    made.low = low;
    made.where = like.where;
    return out_.add(std::move(made));
  }
  NodeId constant(unsigned width) {
    Node made;
    made.width = width;
    made.value = Bits(width, 0);
    return out_.add(std::move(made));
  }

  NodeId add_sub(const Node& like, NodeId a, NodeId b, NodeId s, bool inverted) {
    if (inverted) s = make(Op::kNot, 1, {s}, like);
    return make(Op::kAddSub, out_.nodes[a].width, {a, b, s}, like);
  }

  /// The whole sum from bit 0 of the negation.
  NodeId merged(NodeId add) {
    const auto before = sums_.find(add);
    if (before != sums_.end()) return before->second;
    const Merge& m = merges_.at(add);
    const unsigned width = node(add).width + m.low;
    NodeId a = get(m.other);
    if (m.low > 0) a = make(Op::kConcat, width, {a, constant(m.low)}, node(add));
    NodeId y = get(m.negation.y);
    if (out_.nodes[y].width > width) y = make(Op::kSlice, width, {y}, node(add));
    const NodeId made = add_sub(node(add), a, y, get(m.negation.s), m.negation.inverted);
    if (m.low == 0) out_.nodes[made].name = node(add).name;
    return sums_[add] = made;
  }

  /// The new node; its operands are made before it.
  NodeId get(NodeId id) {
    if (made_[id] == kNoNode) {
      if (node(id).op == Op::kRow) {
        get(n_.row_reads[node(id).port].enable);
        get(n_.row_reads[node(id).port].address);
      }
      made_[id] = copy(id);
    }
    return made_[id];
  }

  NodeId copy(NodeId id) {
    const Node& n = node(id);
    const auto merge = merges_.find(id);
    if (merge != merges_.end()) {
      const NodeId sum = merged(id);
      return merge->second.low == 0 ? sum : make(Op::kSlice, n.width, {sum}, n, merge->second.low);
    }
    if (n.op == Op::kMux) {
      const NodeId both = selected_sum(id);
      if (both != kNoNode) return both;
    }
    if (n.op == Op::kSlice) {
      const auto low = low_bits_.find(n.operands[0]);
      if (low != low_bits_.end() && n.low + n.width <= merges_.at(low->second).low) {
        return make(Op::kSlice, n.width, {merged(low->second)}, n, n.low);
      }
    }
    Node made = n;
    for (NodeId& operand : made.operands) operand = get(operand);
    return out_.add(std::move(made));
  }

  /// s ? a - b : a + b, and the other way round.
  NodeId selected_sum(NodeId id) {
    const Node& n = node(id);
    const Node& yes = node(n.operands[1]);
    const Node& no = node(n.operands[2]);
    const bool inverted = yes.op == Op::kAdd;
    const Node& sum = inverted ? yes : no;
    const Node& difference = inverted ? no : yes;
    if (sum.op != Op::kAdd || difference.op != Op::kSub) return kNoNode;
    const NodeId a = difference.operands[0];
    const NodeId b = difference.operands[1];
    const bool same = (sum.operands[0] == a && sum.operands[1] == b) ||
                      (sum.operands[0] == b && sum.operands[1] == a);
    if (!same || users_[n.operands[1]].size() != 1 || users_[n.operands[2]].size() != 1) {
      return kNoNode;
    }
    const NodeId made = add_sub(n, get(a), get(b), get(n.operands[0]), inverted);
    out_.nodes[made].name = n.name;
    return made;
  }

  const Netlist& n_;
  std::vector<std::vector<NodeId>> users_;
  std::vector<NodeId> made_;
  std::map<NodeId, Merge> merges_;     ///< by the addition
  std::map<NodeId, NodeId> low_bits_;  ///< mux -> the addition that holds its low bits
  std::map<NodeId, NodeId> sums_;      ///< addition -> its sum in the new netlist
  Netlist out_;
};

}  // namespace

Netlist merge_add_sub(const Netlist& netlist) { return MergeAddSub(netlist).run(); }

}  // namespace hlsc
