// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "passes/passes.h"
#include "passes/rewrite.h"

namespace hlsc {
namespace {

constexpr unsigned kMaxDigits = 3;  ///< of a constant factor that becomes additions

class SplitProducts : public Rewrite {
 public:
  SplitProducts(const Netlist& from, const DelayModel& delay)
      : Rewrite(from),
        has_hard_(delay.has_multipliers()),
        hard_(delay.multiplier_width),
        hard_unsigned_(delay.unsigned_multiplier_width) {}

 private:
  struct Factor {
    NodeId id;
    unsigned width;  ///< significant bits
    bool is_signed;
  };
  /// A product to be added at a bit.
  struct Row {
    NodeId id;
    bool negative;
  };

  NodeId make(const Node& n, const std::vector<NodeId>& v) override {
    if (n.op != Op::kMul) return Rewrite::make(n, v);
    return product(builder_.zext(v[0], n.width), builder_.zext(v[1], n.width));
  }

  Factor factor(NodeId id) const {
    const unsigned plain = std::max(1u, builder_.active_bits(id));
    const unsigned with_sign = builder_.signed_bits(id);
    if (plain + 1 <= with_sign || plain < builder_.width(id)) return {id, plain, false};
    return {id, with_sign, true};
  }
  /// The width that a hard multiplier must have for a factor: an unsigned one takes a sign bit more
  /// where the other is signed.
  static unsigned needs(const Factor& factor, const Factor& other) {
    return factor.width + (!factor.is_signed && other.is_signed ? 1 : 0);
  }
  bool fits(const Factor& wider, const Factor& other) const {
    const bool are_unsigned = !wider.is_signed && !other.is_signed;
    return needs(wider, other) <= (are_unsigned ? hard_unsigned_ : hard_);
  }

  NodeId product(NodeId a, NodeId b) {
    const unsigned w = builder_.width(a);
    if (node(a).op == Op::kConst) std::swap(a, b);
    if (builder_.known(b).isConstant()) {
      const NodeId sum = by_constant(a, builder_.known(b).getConstant());
      if (sum != kNoNode) return sum;
    }
    Factor x = factor(a);
    Factor y = factor(b);
    if (needs(x, y) < needs(y, x)) std::swap(x, y);
    if (y.width < DelayModel::kLeastMultiplier || !has_hard_) return by_rows(x.id, y, w);
    if (!fits(x, y)) return by_halves(x, y.id, w);
    return builder_.mul(a, b);
  }

  /// Digits -1, 0, 1, no two neighbours set.
  NodeId by_constant(NodeId a, llvm::APInt value) {
    const unsigned w = builder_.width(a);
    std::vector<Row> rows;
    for (unsigned i = 0; i < w && !value.isZero(); ++i) {
      if (value[0]) {
        const bool negative = value.getBitWidth() > 1 && value[1];
        rows.push_back({shifted(a, i), negative});
        if (negative) {
          ++value;
        } else {
          value.clearBit(0);
        }
      }
      value.lshrInPlace(1);
    }
    if (rows.size() > kMaxDigits) return kNoNode;
    return sum(rows, w);
  }

  NodeId by_rows(NodeId a, const Factor& b, unsigned w) {
    std::vector<Row> rows;
    for (unsigned i = 0; i < b.width; ++i) {
      const NodeId bit = builder_.slice(b.id, i, 1);
      const NodeId row = builder_.logic(Op::kAnd, builder_.sext(bit, w), shifted(a, i));
      rows.push_back({row, b.is_signed && i + 1 == b.width});
    }
    return sum(rows, w);
  }

  /// a = high * 2^k + low, low unsigned.
  NodeId by_halves(const Factor& a, NodeId b, unsigned w) {
    const unsigned k = hard_ - 1;
    const NodeId low = builder_.zext(builder_.trunc(a.id, k), w);
    const NodeId top = builder_.slice(a.id, k, w - k);
    const NodeId high = a.is_signed ? builder_.sext(top, w) : builder_.zext(top, w);
    return builder_.add(product(low, b), shifted(product(high, b), k));
  }

  NodeId shifted(NodeId a, unsigned by) {
    const unsigned w = builder_.width(a);
    if (by == 0) return a;
    if (by >= w) return builder_.constant(w, 0);
    return builder_.concat({builder_.trunc(a, w - by), builder_.constant(by, 0)});
  }

  NodeId sum(std::vector<Row> rows, unsigned w) {
    if (rows.empty()) return builder_.constant(w, 0);
    while (rows.size() > 1) {
      std::vector<Row> next;
      for (std::size_t i = 0; i < rows.size(); i += 2) {
        if (i + 1 == rows.size()) {
          next.push_back(rows[i]);
          continue;
        }
        const Row& p = rows[i];
        const Row& q = rows[i + 1];
        if (p.negative == q.negative) {
          next.push_back({builder_.add(p.id, q.id), p.negative});
        } else {
          next.push_back({p.negative ? builder_.sub(q.id, p.id) : builder_.sub(p.id, q.id), false});
        }
      }
      rows = std::move(next);
    }
    const Row& last = rows.front();
    return last.negative ? builder_.sub(builder_.constant(w, 0), last.id) : last.id;
  }

  bool has_hard_;
  unsigned hard_;
  unsigned hard_unsigned_;
};

}  // namespace

Netlist split_products(const Netlist& netlist, const DelayModel& delay) {
  return SplitProducts(netlist, delay).run();
}

}  // namespace hlsc
