// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "passes/passes.h"
#include "passes/rewrite.h"

namespace hlsc {
namespace {

constexpr std::size_t kMinLogic = 3;    ///< operands of a chain of and, or, xor
constexpr std::size_t kMinMuxes = 4;    ///< muxes of a chain
constexpr std::size_t kMaxMuxes = 128;  ///< longer chains are left: the search is cubic
constexpr int kMinGain = 2;             ///< levels for which the conditions' ORs are spent

/// Logic levels from a node's operands to its result, before anything is expanded.
int levels(const Node& n) {
  const int width = static_cast<int>(n.width);
  switch (n.op) {
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kMux:
      return 1;
    case Op::kEq:
      return 2;
    case Op::kULt:
    case Op::kSLt:
      return 3;
    case Op::kAdd:
    case Op::kSub:
    case Op::kAddSub:
      return 2 + width / 16;
    case Op::kShl:
    case Op::kLShr:
    case Op::kAShr:
    case Op::kClz:
      return 4;
    case Op::kMul:
      return 6;
    case Op::kUDiv:
      return 3 * width;
    default:
      return 0;
  }
}

class BalanceChains : public Rewrite {
 public:
  explicit BalanceChains(const Netlist& from)
      : Rewrite(from), users_(from.nodes.size(), 0), made_(from.nodes.size(), kNoNode) {
    count_users();
    std::vector<bool> inner(from.nodes.size(), false);
    for (std::size_t i = from.nodes.size(); i-- > 0;) {
      const auto id = static_cast<NodeId>(i);
      if (inner[id]) continue;
      if (is_logic(from.nodes[id].op)) find_logic(id, inner);
      if (from.nodes[id].op == Op::kMux) find_muxes(id, inner);
    }
  }

 private:
  /// A value and its selector: `condition`, or its complement.
  struct Choice {
    NodeId condition;
    bool complement;
    NodeId value;
  };
  struct MuxChain {
    std::vector<Choice> choices;  ///< the first that holds decides
    NodeId otherwise;
  };

  static bool is_logic(Op op) { return op == Op::kAnd || op == Op::kOr || op == Op::kXor; }

  void count_users() {
    const auto use = [this](NodeId id) { ++users_[id]; };
    for (const Node& n : from_.nodes) std::for_each(n.operands.begin(), n.operands.end(), use);
    for (const TokenWrite& w : from_.token_writes) use(w.enable), use(w.data);
    for (const RowRead& r : from_.row_reads) use(r.enable), use(r.address);
    for (const RowWrite& w : from_.row_writes) use(w.enable), use(w.address), use(w.data);
    for (const Register& r : from_.registers) {
      if (r.next != kNoNode) use(r.next);
    }
  }

  void find_logic(NodeId root, std::vector<bool>& inner) {
    std::vector<NodeId> leaves;
    std::vector<NodeId> open{root};
    while (!open.empty()) {
      const Node& n = from_.nodes[open.back()];
      open.pop_back();
      for (const NodeId operand : n.operands) {
        if (users_[operand] == 1 && from_.nodes[operand].op == from_.nodes[root].op) {
          inner[operand] = true;
          open.push_back(operand);
        } else {
          leaves.push_back(operand);
        }
      }
    }
    if (leaves.size() >= kMinLogic) logic_[root] = std::move(leaves);
  }

  /// The mux that a data operand is, perhaps with zeros above it, if nobody else looks at it.
  NodeId next_mux(NodeId id, std::vector<NodeId>& passed) const {
    const Node* n = &from_.nodes[id];
    if (n->op == Op::kConcat && n->operands.size() == 2 && users_[id] == 1) {
      const Node& high = from_.nodes[n->operands[0]];
      if (high.op != Op::kConst || !high.value.is_zero()) return kNoNode;
      passed.push_back(id);
      id = n->operands[1];
      n = &from_.nodes[id];
    }
    return n->op == Op::kMux && users_[id] == 1 ? id : kNoNode;
  }

  void find_muxes(NodeId root, std::vector<bool>& inner) {
    MuxChain chain;
    for (NodeId mux = root;;) {
      const Node& n = from_.nodes[mux];
      std::vector<NodeId> passed;
      const NodeId yes = next_mux(n.operands[1], passed);
      const NodeId no = next_mux(n.operands[2], passed);
      const bool in_yes = no == kNoNode && yes != kNoNode;
      chain.choices.push_back({n.operands[0], in_yes, n.operands[in_yes ? 2 : 1]});
      chain.otherwise = n.operands[in_yes ? 1 : 2];
      if ((yes == kNoNode) == (no == kNoNode)) break;  // the end, or a tree
      mux = in_yes ? yes : no;
      inner[mux] = true;
    }
    if (chain.choices.size() < kMinMuxes || chain.choices.size() > kMaxMuxes) return;
    muxes_[root] = std::move(chain);
  }

  NodeId make(const Node& n, const std::vector<NodeId>& operands) override {
    const auto id = static_cast<NodeId>(&n - from_.nodes.data());
    const auto logic = logic_.find(id);
    const auto muxes = muxes_.find(id);
    if (logic != logic_.end()) {
      made_[id] = balanced_logic(n.op, logic->second);
    } else if (muxes != muxes_.end()) {
      made_[id] = balanced_muxes(n, operands, muxes->second);
    } else {
      made_[id] = Rewrite::make(n, operands);
    }
    return made_[id];
  }

  /// Levels from the transaction's start to a node of the new netlist.
  int level(NodeId id) {
    for (NodeId i = static_cast<NodeId>(level_.size()); i <= id; ++i) {
      const Node& n = node(i);
      int latest = 0;
      for (const NodeId operand : n.operands) latest = std::max(latest, level_[operand]);
      if (n.op == Op::kRow) latest = level_[made_[from_.row_reads[n.port].address]] + 3;
      level_.push_back(latest + levels(n));
    }
    return level_[id];
  }

  /// The two that are there first go together, until one is left.
  NodeId balanced_logic(Op op, const std::vector<NodeId>& leaves) {
    std::vector<NodeId> open;
    for (const NodeId leaf : leaves) open.push_back(made_[leaf]);
    const auto later = [this](NodeId a, NodeId b) {
      return level(a) != level(b) ? level(a) > level(b) : a > b;
    };
    std::sort(open.begin(), open.end(), later);
    while (open.size() > 1) {
      const NodeId a = open.back();
      open.pop_back();
      const NodeId both = builder_.logic(op, a, open.back());
      open.pop_back();
      open.insert(std::upper_bound(open.begin(), open.end(), both, later), both);
    }
    return open.front();
  }

  /// A chain of muxes as a tree: any condition of the first part decides between the parts. A
  /// search finds the place to part; a chain whose first conditions arrive last stays as it is.
  class MuxTree {
   public:
    MuxTree(BalanceChains& pass, std::vector<NodeId> conditions, std::vector<NodeId> values)
        : pass_(pass),
          conditions_(std::move(conditions)),
          values_(std::move(values)),
          any_(table(conditions_)),
          value_(table(values_)) {
      const std::size_t n = values_.size();
      for (std::size_t length = 2; length <= n; ++length) {
        for (std::size_t i = 0; i + length <= n; ++i) plan(i, i + length - 1);
      }
    }

    int level() const { return value_[0][values_.size() - 1].level; }
    int serial_level() const {
      int serial = value_[values_.size() - 1][values_.size() - 1].level;
      for (std::size_t i = conditions_.size(); i-- > 0;) {
        serial = std::max({serial, any_[i][i].level, value_[i][i].level}) + 1;
      }
      return serial;
    }
    NodeId build() { return value(0, values_.size() - 1); }

   private:
    struct Cell {
      int level = 0;
      std::size_t parting = 0;  ///< last place of the first part
      NodeId made = kNoNode;
    };
    using Table = std::vector<std::vector<Cell>>;

    Table table(const std::vector<NodeId>& nodes) const {
      Table cells(nodes.size(), std::vector<Cell>(nodes.size()));
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        cells[i][i] = {pass_.level(nodes[i]), i, nodes[i]};
      }
      return cells;
    }

    void plan(std::size_t i, std::size_t j) {
      Cell& value = value_[i][j];
      value.level = -1;
      const bool is_any = j < conditions_.size();
      if (is_any) any_[i][j].level = -1;
      for (std::size_t k = i; k < j; ++k) {
        const int first = std::max(any_[i][k].level, value_[i][k].level);
        keep_least(value, std::max(first, value_[k + 1][j].level) + 1, k);
        if (is_any) {
          keep_least(any_[i][j], std::max(any_[i][k].level, any_[k + 1][j].level) + 1, k);
        }
      }
    }
    static void keep_least(Cell& cell, int level, std::size_t parting) {
      if (cell.level < 0 || level < cell.level) cell = {level, parting, kNoNode};
    }

    NodeId any(std::size_t i, std::size_t j) {
      Cell& cell = any_[i][j];
      if (cell.made == kNoNode) {
        cell.made = pass_.builder_.logic(Op::kOr, any(i, cell.parting), any(cell.parting + 1, j));
      }
      return cell.made;
    }
    NodeId value(std::size_t i, std::size_t j) {
      Cell& cell = value_[i][j];
      if (cell.made == kNoNode) {
        cell.made = pass_.builder_.mux(any(i, cell.parting), value(i, cell.parting),
                                       value(cell.parting + 1, j));
      }
      return cell.made;
    }

    BalanceChains& pass_;
    std::vector<NodeId> conditions_;
    std::vector<NodeId> values_;
    Table any_;
    Table value_;
  };

  NodeId balanced_muxes(const Node& root, const std::vector<NodeId>& operands,
                        const MuxChain& chain) {
    std::vector<NodeId> conditions;
    std::vector<NodeId> values;
    for (const Choice& choice : chain.choices) {
      const NodeId condition = made_[choice.condition];
      conditions.push_back(choice.complement ? builder_.invert(condition) : condition);
      values.push_back(builder_.zext(made_[choice.value], root.width));
    }
    values.push_back(builder_.zext(made_[chain.otherwise], root.width));
    MuxTree tree(*this, std::move(conditions), std::move(values));
    if (tree.level() + kMinGain > tree.serial_level()) return Rewrite::make(root, operands);
    return tree.build();
  }

  std::vector<unsigned> users_;
  std::vector<NodeId> made_;
  std::vector<int> level_;
  std::map<NodeId, std::vector<NodeId>> logic_;
  std::map<NodeId, MuxChain> muxes_;
};

}  // namespace

Netlist balance_chains(const Netlist& netlist) { return BalanceChains(netlist).run(); }

}  // namespace hlsc
