// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "passes/passes.h"
#include "passes/rewrite.h"

namespace hlsc {
namespace {

constexpr unsigned kAhead = 2;  ///< groups of 2^kAhead zeros and more are looked for ahead

class ExpandShifts : public Rewrite {
 public:
  using Rewrite::Rewrite;

 private:
  struct Normalised {
    NodeId of;
    NodeId value;
  };

  NodeId make(const Node& n, const std::vector<NodeId>& v) override {
    switch (n.op) {
      case Op::kClz:
        return count(v[0], n.width);
      case Op::kShl:
      case Op::kLShr:
      case Op::kAShr: {
        const auto counted = normalised_.find(v[1]);
        if (n.op == Op::kShl && counted != normalised_.end() && counted->second.of == v[0]) {
          return counted->second.value;
        }
        const NodeId made = shift(n.op, v[0], v[1]);
        if (n.op != Op::kAShr) zero_with_[made] = v[0];
        return made;
      }
      case Op::kMux: {
        // A shifted zero stays zero.
        const auto shifted = zero_with_.find(v[2]);
        if (is_zero(v[1]) && shifted != zero_with_.end() && v[0] == zero_test(shifted->second)) {
          return v[2];
        }
        return Rewrite::make(n, v);
      }
      default:
        return Rewrite::make(n, v);
    }
  }

  NodeId constant_shift(Op op, NodeId a, unsigned by) {
    return builder_.shift(op, a, builder_.constant(32, by));
  }

  NodeId shift(Op op, NodeId a, NodeId amount) {
    const unsigned w = builder_.width(a);
    // By one of two constants.
    if (node(amount).op == Op::kMux) {
      const std::vector<NodeId> selected = node(amount).operands;
      if (node(selected[1]).op == Op::kConst && node(selected[2]).op == Op::kConst) {
        return builder_.mux(selected[0], shift(op, a, selected[1]), shift(op, a, selected[2]));
      }
    }
    if (node(amount).op == Op::kConst) return builder_.shift(op, a, amount);
    NodeId value = a;
    const unsigned bits = std::max(1u, builder_.active_bits(amount));
    for (unsigned k = bits; k-- > 0;) {
      const NodeId by = builder_.slice(amount, k, 1);
      const bool out = k >= 31 || (1u << k) >= w;
      const NodeId moved = constant_shift(op, value, out ? w : 1u << k);
      value = builder_.mux(by, moved, value);
    }
    return value;
  }

  /// Leading zeros, and the value shifted up by them, in one row of layers.
  NodeId count(NodeId of, unsigned width) {
    NodeId a = of;
    // A one behind the bits that are counted only says what a zero counts as.
    const Node& n = node(of);
    if (n.op == Op::kConcat && node(n.operands.back()).op == Op::kConst) {
      const Bits& tail = node(n.operands.back()).value;
      if (tail.bit(tail.width() - 1)) {
        a = builder_.slice(of, tail.width(), builder_.width(of) - tail.width());
      }
    }
    const unsigned w = builder_.width(a);
    const bool never_zero = !builder_.known(a).getMinValue().isZero();
    const NodeId some = never_zero ? builder_.constant(1, 1) : builder_.invert(zero_test(a));
    unsigned layers = 0;
    while ((1u << layers) < w) ++layers;

    std::vector<std::vector<NodeId>> groups = zero_groups(a, layers);
    NodeId value = a;
    std::vector<NodeId> bits;  // highest first
    if ((w >> layers & 1) != 0) bits.push_back(builder_.invert(some));
    for (unsigned k = layers; k-- > 0;) {
      const unsigned size = 1u << k;
      const NodeId empty =
          k >= kAhead ? groups[k][0] : zero_test(builder_.slice(value, w - size, size));
      value = builder_.mux(empty, constant_shift(Op::kShl, value, size), value);
      for (unsigned j = kAhead; j < k; ++j) {
        auto& flags = groups[j];
        const std::size_t half = std::size_t{1} << (k - j);
        for (std::size_t i = 0; i < half; ++i) {
          flags[i] = builder_.mux(empty, flags[i + half], flags[i]);
        }
      }
      // Of zero every layer finds nothing: its count is put right bit by bit.
      bits.push_back((w >> k & 1) != 0 ? empty : both(empty, some));
    }
    if (bits.empty()) bits.push_back(builder_.invert(some));
    const NodeId zeros = builder_.concat(bits);
    const NodeId made =
        builder_.width(zeros) >= width ? builder_.trunc(zeros, width) : builder_.zext(zeros, width);
    if (width >= builder_.width(zeros)) normalised_[made] = {a, value};
    zero_with_[value] = a;
    return made;
  }

  /// [k][i]: bits i * 2^k and on from the top, 2^k of them, are zero; zero lies beyond the lowest.
  std::vector<std::vector<NodeId>> zero_groups(NodeId a, unsigned layers) {
    const unsigned w = builder_.width(a);
    std::vector<std::vector<NodeId>> groups(layers);
    for (unsigned k = kAhead; k < layers; ++k) {
      const unsigned size = 1u << k;
      for (unsigned i = 0; i < (1u << (layers - k)); ++i) {
        if (k > kAhead) {
          groups[k].push_back(both(groups[k - 1][2 * i], groups[k - 1][2 * i + 1]));
          continue;
        }
        const unsigned top = w > i * size ? w - i * size : 0;
        const unsigned has = std::min(size, top);
        groups[k].push_back(has == 0 ? builder_.constant(1, 1)
                                     : zero_test(builder_.slice(a, top - has, has)));
      }
    }
    return groups;
  }

  std::map<NodeId, Normalised> normalised_;  ///< by the count
  std::map<NodeId, NodeId> zero_with_;       ///< values that are zero if another one is
};

}  // namespace

Netlist expand_shifts(const Netlist& netlist) { return ExpandShifts(netlist).run(); }

}  // namespace hlsc
