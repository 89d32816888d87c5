// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "netlist/builder.h"

#include <llvm/ADT/StringExtras.h>

#include <algorithm>

namespace hlsc {

using llvm::APInt;
using llvm::KnownBits;

Bits to_bits(const APInt& value) {
  Bits bits(value.getBitWidth(), 0);
  for (unsigned i = 0; i < value.getBitWidth(); ++i) {
    if (value[i]) bits.set(i, true);
  }
  return bits;
}

APInt to_apint(const Bits& bits) {
  APInt value(bits.width(), 0);
  for (unsigned i = 0; i < bits.width(); ++i) {
    if (bits.bit(i)) value.setBit(i);
  }
  return value;
}

void Builder::name(NodeId id, const std::string& name) {
  Node& named = net_.nodes[id];
  if (named.name.empty() && named.op != Op::kConst) named.name = name;
}

Builder::Facts Builder::facts_from(KnownBits known, unsigned sign_copies) const {
  sign_copies = std::max({sign_copies, known.countMinSignBits(), 1u});
  sign_copies = std::min(sign_copies, known.getBitWidth());
  return {std::move(known), sign_copies};
}

NodeId Builder::make(Op op, unsigned width, llvm::ArrayRef<NodeId> operands, Facts facts,
                     unsigned low, unsigned port) {
  if (op != Op::kRegister && facts.known.isConstant()) return constant(facts.known.getConstant());
  const Key key{op, width, {operands.begin(), operands.end()}, low, port};
  const auto found = known_nodes_.find(key);
  if (found != known_nodes_.end()) return found->second;
  Node made;
  made.op = op;
  made.width = width;
  made.operands.assign(operands.begin(), operands.end());
  made.low = low;
  made.port = port;
  made.where = where_;
  const NodeId id = net_.add(std::move(made));
  facts_.push_back(std::move(facts));
  known_nodes_.emplace(key, id);
  return id;
}

NodeId Builder::constant(const APInt& value) {
  const std::string key =
      std::to_string(value.getBitWidth()) + "'" + llvm::toString(value, 16, false);
  const auto found = constants_.find(key);
  if (found != constants_.end()) return found->second;
  Node made;
  made.op = Op::kConst;
  made.width = value.getBitWidth();
  made.value = to_bits(value);
  const NodeId id = net_.add(std::move(made));
  facts_.push_back(facts_from(KnownBits::makeConstant(value)));
  constants_.emplace(key, id);
  return id;
}

NodeId Builder::source(Op op, unsigned port, unsigned low, unsigned width) {
  KnownBits known(width);
  if (op == Op::kRegister) {
    const auto active = register_active_.find(port);
    if (active != register_active_.end() && active->second < width) {
      known.Zero.setBitsFrom(active->second);
    }
  }
  return make(op, width, {}, facts_from(known), low, port);
}

NodeId Builder::arithmetic(Op op, NodeId a, NodeId b) {
  const unsigned w = width(a);
  const bool is_add = op == Op::kAdd;
  if (known(b).isZero()) return a;
  if (is_add && known(a).isZero()) return b;
  if (is_add && is_constant(a)) std::swap(a, b);
  if (!is_add && a == b) return constant(w, 0);
  if (w == 1) return logic(Op::kXor, a, b);

  // Low bits that one operand leaves as they are.
  const unsigned idle =
      is_add ? std::max(known(a).countMinTrailingZeros(), known(b).countMinTrailingZeros())
             : known(b).countMinTrailingZeros();
  if (idle > 0 && idle < w) {
    const bool keep_a = known(b).countMinTrailingZeros() >= idle;
    const NodeId low = slice(keep_a ? a : b, 0, idle);
    const NodeId high = arithmetic(op, slice(a, idle, w - idle), slice(b, idle, w - idle));
    return concat({high, low});
  }

  const KnownBits result = KnownBits::computeForAddSub(is_add, false, false, known(a), known(b));
  const unsigned active = result.countMaxActiveBits();
  const unsigned significant = std::max(signed_bits(a), signed_bits(b)) + 1;
  const unsigned least = std::min(active, significant);
  if (least < w && least > 0) {
    const NodeId narrow = arithmetic(op, trunc(a, least), trunc(b, least));
    return active <= significant ? zext(narrow, w) : sext(narrow, w);
  }
  if (is_add && a > b && !is_constant(b)) std::swap(a, b);
  return make(op, w, {a, b}, facts_from(result, w - std::min(w, significant) + 1));
}

NodeId Builder::mul(NodeId a, NodeId b) {
  const unsigned w = width(a);
  if (is_constant(a)) std::swap(a, b);
  if (known(b).isConstant() && known(b).getConstant().isPowerOf2()) {
    return constant_shift(Op::kShl, a, known(b).getConstant().logBase2());
  }
  if (known(a).isZero() || known(b).isZero()) return constant(w, 0);
  const unsigned zeros_a = known(a).countMinTrailingZeros();
  const unsigned zeros_b = known(b).countMinTrailingZeros();
  if (zeros_a + zeros_b > 0) {
    const NodeId product =
        mul(constant_shift(Op::kLShr, a, zeros_a), constant_shift(Op::kLShr, b, zeros_b));
    return zeros_a + zeros_b >= w ? constant(w, 0)
                                  : constant_shift(Op::kShl, product, zeros_a + zeros_b);
  }
  const unsigned active = active_bits(a) + active_bits(b);
  const unsigned significant = signed_bits(a) + signed_bits(b);
  const unsigned least = std::min(active, significant);
  if (least < w) {
    const NodeId narrow = mul(trunc(a, least), trunc(b, least));
    return active <= significant ? zext(narrow, w) : sext(narrow, w);
  }
  KnownBits result = KnownBits::mul(known(a), known(b));
  // Unsigned operands are handed over as narrow as they are.
  const unsigned narrow_a = std::max(1u, active_bits(a));
  const unsigned narrow_b = std::max(1u, active_bits(b));
  NodeId x = trunc(a, narrow_a);
  NodeId y = trunc(b, narrow_b);
  if (x > y && !is_constant(y)) std::swap(x, y);
  return make(Op::kMul, w, {x, y}, facts_from(result));
}

NodeId Builder::udiv(NodeId a, NodeId b) {
  const unsigned w = width(a);
  if (known(b).isConstant() && known(b).getConstant().isPowerOf2()) {
    return constant_shift(Op::kLShr, a, known(b).getConstant().logBase2());
  }
  const unsigned active_a = std::max(1u, active_bits(a));
  const unsigned active_b = std::max(1u, active_bits(b));
  if (active_a < w || active_b < width(b)) {
    return zext(udiv(trunc(a, active_a), trunc(b, active_b)), w);
  }
  const unsigned common = std::max(w, width(b));
  const KnownBits divisor = known(b).zext(common);
  KnownBits result(w);
  if (!divisor.getMinValue().isZero()) {
    result = KnownBits::udiv(known(a).zext(common), divisor).trunc(w);
  }
  return make(Op::kUDiv, w, {a, b}, facts_from(result));
}

NodeId Builder::invert(NodeId a) {
  if (node(a).op == Op::kNot) return node(a).operands[0];
  if (node(a).op == Op::kSExt) return sext(invert(node(a).operands[0]), width(a));
  KnownBits result = known(a);
  std::swap(result.Zero, result.One);
  return make(Op::kNot, width(a), {a}, facts_from(result, facts_[a].sign_copies));
}

NodeId Builder::clz(NodeId a, unsigned w) {
  const unsigned count_width = llvm::Log2_32(width(a)) + 1;
  if (w != count_width) {
    const NodeId count = clz(a, count_width);
    return w > count_width ? zext(count, w) : trunc(count, w);
  }
  KnownBits result(w);
  const unsigned most = known(a).countMaxLeadingZeros();
  result.Zero.setBitsFrom(std::min(w, llvm::Log2_32(std::max(most, 1u)) + 1));
  return make(Op::kClz, w, {a}, facts_from(result));
}

NodeId Builder::shift(Op op, NodeId a, NodeId amount) {
  const unsigned w = width(a);
  if (is_constant(amount)) {
    const auto by = known(amount).getConstant().getLimitedValue(w);
    return constant_shift(op, a, static_cast<unsigned>(by));
  }
  if (op == Op::kAShr && known(a).isNonNegative()) op = Op::kLShr;
  if (known(a).isZero()) return a;
  amount = trunc(amount, std::max(1u, active_bits(amount)));
  const NodeId two_ways = two_way_shift(op, a, amount);
  if (two_ways != kNoNode) return two_ways;
  if (op == Op::kLShr && active_bits(a) < w) {
    return zext(shift(op, trunc(a, active_bits(a)), amount), w);
  }
  if (op == Op::kAShr && signed_bits(a) < w) {
    return sext(shift(op, trunc(a, signed_bits(a)), amount), w);
  }
  const APInt most = known(amount).getMaxValue();
  KnownBits result(w);
  unsigned copies = 1;
  if (op == Op::kShl) {
    const auto grown = active_bits(a) + most.getLimitedValue(w);
    if (grown < w) {
      const auto narrow = static_cast<unsigned>(grown);
      return zext(shift(op, trunc(a, narrow), amount), w);
    }
    result.Zero.setLowBits(known(a).countMinTrailingZeros());
    const auto lost = most.getLimitedValue(w);
    if (facts_[a].sign_copies > lost) copies = facts_[a].sign_copies - static_cast<unsigned>(lost);
  }
  return make(op, w, {a, amount}, facts_from(result, copies));
}

/// A shift by one of two distances is a mux of wirings; LLVM makes the shift of it.
NodeId Builder::two_way_shift(Op op, NodeId a, NodeId amount) {
  const KnownBits& distance = known(amount);
  const APInt unknown = ~(distance.Zero | distance.One);
  if (unknown.popcount() != 1 || width(amount) == 1) return kNoNode;
  const unsigned w = width(a);
  const auto near = static_cast<unsigned>(distance.getMinValue().getLimitedValue(w));
  const auto far = static_cast<unsigned>(distance.getMaxValue().getLimitedValue(w));
  const NodeId is_far = slice(amount, unknown.logBase2(), 1);
  const NodeId far_value = constant_shift(op, a, far);
  return mux(is_far, far_value, constant_shift(op, a, near));
}

NodeId Builder::constant_shift(Op op, NodeId a, unsigned amount) {
  const unsigned w = width(a);
  if (amount == 0) return a;
  if (op == Op::kAShr) {
    amount = std::min(amount, w - 1);
    return sext(slice(a, amount, w - amount), w);
  }
  if (amount >= w) return constant(w, 0);
  if (op == Op::kShl) return concat({slice(a, 0, w - amount), constant(amount, 0)});
  return zext(slice(a, amount, w - amount), w);
}

}  // namespace hlsc
