// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The builder's bitwise operations, comparisons and wiring.
#include <algorithm>

#include "netlist/builder.h"

namespace hlsc {

using llvm::APInt;
using llvm::KnownBits;

namespace {

constexpr unsigned kMaxSegments = 6;  ///< a mask that cuts a word into more is left as an operation

KnownBits known_logic(Op op, const KnownBits& a, const KnownBits& b) {
  switch (op) {
    case Op::kAnd:
      return a & b;
    case Op::kOr:
      return a | b;
    default:
      return a ^ b;
  }
}

enum class Source : std::uint8_t { kBoth, kFirst, kSecond, kZero, kOne };

/// A bit of `a op b`, given the known bits of both.
Source bit_source(Op op, const KnownBits& a, const KnownBits& b, unsigned i) {
  const KnownBits result = known_logic(op, a, b);
  if (result.Zero[i]) return Source::kZero;
  if (result.One[i]) return Source::kOne;
  const bool neutral_is_one = op == Op::kAnd;
  if (neutral_is_one ? b.One[i] : b.Zero[i]) return Source::kFirst;
  if (neutral_is_one ? a.One[i] : a.Zero[i]) return Source::kSecond;
  return Source::kBoth;
}

}  // namespace

/// Cuts the operation where one operand's bits are known, if that leaves at most one operation.
NodeId Builder::wired_logic(Op op, NodeId a, NodeId b) {
  struct Segment {
    Source source;
    unsigned low;
    unsigned width;
  };
  const unsigned w = width(a);
  const KnownBits known_a = known(a);
  const KnownBits known_b = known(b);
  std::vector<Segment> segments;
  unsigned operations = 0;
  for (unsigned i = 0; i < w; ++i) {
    const Source source = bit_source(op, known_a, known_b, i);
    if (!segments.empty() && segments.back().source == source) {
      ++segments.back().width;
      continue;
    }
    if (source == Source::kBoth) ++operations;
    segments.push_back({source, i, 1});
  }
  const bool worth = operations == 0 ? segments.size() <= 4 * kMaxSegments
                                     : operations == 1 && segments.size() <= kMaxSegments;
  if (!worth || (segments.size() == 1 && operations == 1)) return kNoNode;
  std::vector<NodeId> parts;
  for (const Segment& s : segments) {
    NodeId part = kNoNode;
    switch (s.source) {
      case Source::kBoth:
        part = logic(op, slice(a, s.low, s.width), slice(b, s.low, s.width));
        break;
      case Source::kFirst:
        part = slice(a, s.low, s.width);
        break;
      case Source::kSecond:
        part = slice(b, s.low, s.width);
        break;
      case Source::kZero:
        part = constant(s.width, 0);
        break;
      case Source::kOne:
        part = constant(APInt::getAllOnes(s.width));
        break;
    }
    parts.insert(parts.begin(), part);
  }
  return concat(parts);
}

NodeId Builder::logic(Op op, NodeId a, NodeId b) {
  const unsigned w = width(a);
  if (is_constant(a)) std::swap(a, b);
  if (a == b) return op == Op::kXor ? constant(w, 0) : a;
  if (is_constant(b) && op == Op::kXor && known(b).isAllOnes()) return invert(a);
  const bool complement = (node(a).op == Op::kNot && node(a).operands[0] == b) ||
                          (node(b).op == Op::kNot && node(b).operands[0] == a);
  if (complement) return op == Op::kAnd ? constant(w, 0) : constant(APInt::getAllOnes(w));
  const NodeId wired = wired_logic(op, a, b);
  if (wired != kNoNode) return wired;
  const unsigned copies = std::min(facts_[a].sign_copies, facts_[b].sign_copies);
  if (copies > 1) {
    return sext(logic(op, trunc(a, w - copies + 1), trunc(b, w - copies + 1)), w);
  }
  if (a > b && !is_constant(b)) std::swap(a, b);
  return make(op, w, {a, b}, facts_from(known_logic(op, known(a), known(b)), copies));
}

NodeId Builder::equal(NodeId a, NodeId b) {
  if (a == b) return constant(1, 1);
  if (is_constant(a)) std::swap(a, b);
  const unsigned w = width(a);
  const APInt differ = (known(a).One & known(b).Zero) | (known(a).Zero & known(b).One);
  if (!differ.isZero()) return constant(1, 0);
  const APInt same = (known(a).One & known(b).One) | (known(a).Zero & known(b).Zero);
  const unsigned high = same.countl_one();
  const unsigned low = same.countr_one();
  if (high + low > 0 && high + low < w) {
    return equal(slice(a, low, w - high - low), slice(b, low, w - high - low));
  }
  const unsigned copies = std::min(facts_[a].sign_copies, facts_[b].sign_copies);
  if (copies > 1) return equal(trunc(a, w - copies + 1), trunc(b, w - copies + 1));
  if (w == 1) {
    if (is_constant(b)) return known(b).isZero() ? invert(a) : a;
    return invert(logic(Op::kXor, a, b));
  }
  if (a > b && !is_constant(b)) std::swap(a, b);
  return make(Op::kEq, 1, {a, b}, facts_from(KnownBits(1)));
}

NodeId Builder::less(Op op, NodeId a, NodeId b) {
  const unsigned w = width(a);
  if (a == b) return constant(1, 0);
  const bool is_unsigned = op == Op::kULt;
  const auto decided =
      is_unsigned ? KnownBits::ult(known(a), known(b)) : KnownBits::slt(known(a), known(b));
  if (decided) return constant(1, *decided ? 1 : 0);
  if (is_unsigned) {
    const unsigned active = std::max(active_bits(a), active_bits(b));
    if (active < w) return less(op, trunc(a, active), trunc(b, active));
    if (is_constant(b) && known(b).getConstant().isPowerOf2()) {
      const unsigned bit = known(b).getConstant().logBase2();
      return equal(slice(a, bit, w - bit), constant(w - bit, 0));
    }
    if (is_constant(a) && (known(a).getConstant() + 1).isPowerOf2()) {
      const unsigned bit = (known(a).getConstant() + 1).logBase2();
      return invert(equal(slice(b, bit, w - bit), constant(w - bit, 0)));
    }
  } else {
    if (known(a).isNonNegative() && known(b).isNonNegative()) return less(Op::kULt, a, b);
    const unsigned significant = std::max(signed_bits(a), signed_bits(b));
    if (significant < w) return less(op, trunc(a, significant), trunc(b, significant));
    if (known(b).isZero()) return slice(a, w - 1, 1);
    if (known(a).isAllOnes()) return invert(slice(b, w - 1, 1));
  }
  if (w == 1) {
    return is_unsigned ? logic(Op::kAnd, invert(a), b) : logic(Op::kAnd, a, invert(b));
  }
  return make(op, 1, {a, b}, facts_from(KnownBits(1)));
}

NodeId Builder::mux(NodeId s, NodeId a, NodeId b) {
  if (is_constant(s)) return known(s).isZero() ? b : a;
  if (a == b) return a;
  if (node(s).op == Op::kNot) return mux(node(s).operands[0], b, a);
  const unsigned w = width(a);
  if (w == 1) {
    if (a == s) a = constant(1, 1);
    if (b == s) b = constant(1, 0);
    if (is_constant(a)) {
      return known(a).isZero() ? logic(Op::kAnd, invert(s), b) : logic(Op::kOr, s, b);
    }
    if (is_constant(b)) {
      return known(b).isZero() ? logic(Op::kAnd, s, a) : logic(Op::kOr, invert(s), a);
    }
  }
  KnownBits result = known(a).intersectWith(known(b));
  const APInt fixed = result.Zero | result.One;
  const unsigned high = fixed.countl_one();
  const unsigned low = fixed.countr_one();
  if (high + low > 0 && high + low < w) {
    llvm::SmallVector<NodeId, 3> parts;
    if (high > 0) parts.push_back(constant(result.One.extractBits(high, w - high)));
    parts.push_back(mux(s, slice(a, low, w - high - low), slice(b, low, w - high - low)));
    if (low > 0) parts.push_back(constant(result.One.extractBits(low, 0)));
    return concat(parts);
  }
  const unsigned copies = std::min(facts_[a].sign_copies, facts_[b].sign_copies);
  if (copies > 1) {
    return sext(mux(s, trunc(a, w - copies + 1), trunc(b, w - copies + 1)), w);
  }
  return make(Op::kMux, w, {s, a, b}, facts_from(result, copies));
}

NodeId Builder::slice(NodeId a, unsigned low, unsigned w) {
  if (low == 0 && w == width(a)) return a;
  const Node& of = node(a);
  const KnownBits part = known(a).extractBits(w, low);
  if (part.isConstant()) return constant(part.getConstant());
  switch (of.op) {
    case Op::kSlice:
      return slice(of.operands[0], of.low + low, w);
    case Op::kToken:
    case Op::kConfig:
    case Op::kRow:
      return source(of.op, of.port, of.low + low, w);
    case Op::kSExt: {
      const NodeId inner = of.operands[0];
      const unsigned inner_width = width(inner);
      if (low + w <= inner_width) return slice(inner, low, w);
      if (low >= inner_width) return sext(slice(inner, inner_width - 1, 1), w);
      return sext(slice(inner, low, inner_width - low), w);
    }
    case Op::kConcat: {
      const std::vector<NodeId> operands = of.operands;
      llvm::SmallVector<NodeId, 4> parts;
      unsigned top = width(a);
      for (NodeId operand : operands) {
        const unsigned bottom = top - width(operand);
        const unsigned from = std::max(low, bottom);
        const unsigned to = std::min(low + w, top);
        if (from < to) parts.push_back(slice(operand, from - bottom, to - from));
        top = bottom;
      }
      return concat(parts);
    }
    default:
      break;
  }
  unsigned copies = 1;
  if (low + w > signed_bits(a)) copies = low + w - std::max(low, signed_bits(a) - 1);
  return make(Op::kSlice, w, {a}, facts_from(part, std::min(copies, w)), low);
}

NodeId Builder::concat(llvm::ArrayRef<NodeId> highest_first) {
  // Flat, with neighbours joined that are slices of one node, bits of one source, or constants.
  llvm::SmallVector<NodeId, 8> flat;
  for (NodeId part : highest_first) {
    if (node(part).op == Op::kConcat) {
      flat.append(node(part).operands.begin(), node(part).operands.end());
    } else {
      flat.push_back(part);
    }
  }
  llvm::SmallVector<NodeId, 8> parts;
  for (NodeId part : flat) {
    const NodeId joined = parts.empty() ? kNoNode : join(parts.back(), part);
    if (joined == kNoNode) {
      parts.push_back(part);
    } else {
      parts.back() = joined;
    }
  }
  if (parts.size() == 1) return parts.front();
  unsigned w = 0;
  for (NodeId part : parts) w += width(part);
  KnownBits result(w);
  unsigned top = w;
  for (NodeId part : parts) {
    top -= width(part);
    result.insertBits(known(part), top);
  }
  return make(Op::kConcat, w, parts, facts_from(result, facts_[parts.front()].sign_copies));
}

/// The node that is {high, low} without a concat, or kNoNode.
NodeId Builder::join(NodeId high, NodeId low) {
  const Node& h = node(high);
  const Node& l = node(low);
  if (h.op == Op::kConst && l.op == Op::kConst) {
    return constant(known(high).getConstant().concat(known(low).getConstant()));
  }
  const bool sliced_high = h.op == Op::kSlice;
  const NodeId base_high = sliced_high ? h.operands[0] : high;
  const NodeId base_low = l.op == Op::kSlice ? l.operands[0] : low;
  if (sliced_high && base_high == base_low) {
    const unsigned low_start = l.op == Op::kSlice ? l.low : 0;
    if (low != base_low && h.low == low_start + l.width) {
      return slice(base_high, low_start, h.width + l.width);
    }
  }
  const bool source_bits = h.op == Op::kToken || h.op == Op::kConfig || h.op == Op::kRow;
  if (source_bits && h.op == l.op && h.port == l.port && h.low == l.low + l.width) {
    return source(l.op, l.port, l.low, h.width + l.width);
  }
  return kNoNode;
}

NodeId Builder::sext(NodeId a, unsigned w) {
  const unsigned from = width(a);
  if (w == from) return a;
  if (w < from) return trunc(a, w);
  if (known(a).isNonNegative()) return zext(a, w);
  if (node(a).op == Op::kSExt) return sext(node(a).operands[0], w);
  return make(Op::kSExt, w, {a}, facts_from(known(a).sext(w), w - from + facts_[a].sign_copies));
}

NodeId Builder::zext(NodeId a, unsigned w) {
  const unsigned from = width(a);
  if (w <= from) return w == from ? a : trunc(a, w);
  return concat({constant(w - from, 0), a});
}

}  // namespace hlsc
