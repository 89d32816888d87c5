// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "netlist/evaluate.h"

#include <stdexcept>

#include "netlist/op.h"

namespace hlsc {
namespace {

using Word = std::uint64_t;
__extension__ using DoubleWord = unsigned __int128;

template <class F>
Bits word_by_word(const Bits& a, const Bits& b, F&& f) {
  Bits result(a.width(), 0);
  for (unsigned i = 0; i < result.words(); ++i) result.set_word(i, f(a.word(i), b.word(i)));
  return result;
}

Bits add(const Bits& a, const Bits& b, bool carry) {
  Bits result(a.width(), 0);
  for (unsigned i = 0; i < result.words(); ++i) {
    const DoubleWord sum = DoubleWord{a.word(i)} + b.word(i) + (carry ? 1 : 0);
    result.set_word(i, static_cast<Word>(sum));
    carry = (sum >> 64) != 0;
  }
  return result;
}

Bits multiply(const Bits& a, const Bits& b, unsigned width) {
  Bits result(width, 0);
  for (unsigned i = 0; i < a.words(); ++i) {
    Word carry = 0;
    for (unsigned j = 0; i + j < result.words(); ++j) {
      const DoubleWord sum = DoubleWord{a.word(i)} * b.word(j) + result.word(i + j) + carry;
      result.set_word(i + j, static_cast<Word>(sum));
      carry = static_cast<Word>(sum >> 64);
    }
  }
  return result;
}

bool less(const Bits& a, const Bits& b) {
  for (unsigned i = a.words() > b.words() ? a.words() : b.words(); i-- > 0;) {
    if (a.word(i) != b.word(i)) return a.word(i) < b.word(i);
  }
  return false;
}

Bits shift_left(const Bits& a, Word by) {
  Bits result(a.width(), 0);
  if (by >= a.width()) return result;
  const auto words = static_cast<unsigned>(by / 64);
  const auto bits = static_cast<unsigned>(by % 64);
  for (unsigned i = result.words(); i-- > words;) {
    Word w = a.word(i - words) << bits;
    if (bits > 0 && i > words) w |= a.word(i - words - 1) >> (64 - bits);
    result.set_word(i, w);
  }
  return result;
}

/// The shift's distance, no more than `limit`.
Word distance(const Bits& by, Word limit) {
  for (unsigned i = 1; i < by.words(); ++i) {
    if (by.word(i) != 0) return limit;
  }
  return by.word(0) < limit ? by.word(0) : limit;
}

Bits shift_right(const Bits& a, Word by) {
  Bits result(a.width(), 0);
  if (by < a.width()) {
    insert(result, 0, extract(a, static_cast<unsigned>(by), a.width() - static_cast<unsigned>(by)));
  }
  return result;
}

Bits shift_right_signed(const Bits& a, Word by) {
  const bool sign = a.bit(a.width() - 1);
  if (!sign) return shift_right(a, by);
  return invert(shift_right(invert(a), by));
}

Bits divide(const Bits& a, const Bits& b) {
  const unsigned work = (a.width() > b.width() ? a.width() : b.width()) + 1;
  const Bits divisor = zero_extend(b, work);
  Bits rest(work, 0);
  Bits quotient(a.width(), 0);
  for (unsigned i = a.width(); i-- > 0;) {
    rest = shift_left(rest, 1);
    rest.set(0, a.bit(i));
    if (!less(rest, divisor)) {
      rest = add(rest, invert(divisor), true);
      quotient.set(i, true);
    }
  }
  return quotient;
}

Bits flip_sign(Bits a) {
  a.set(a.width() - 1, !a.bit(a.width() - 1));
  return a;
}

}  // namespace

Bits extract(const Bits& from, unsigned low, unsigned width) {
  Bits result(width, 0);
  for (unsigned i = 0; i < result.words(); ++i) {
    const unsigned start = low + 64 * i;
    Word w = from.word(start / 64) >> (start % 64);
    if (start % 64 != 0) w |= from.word(start / 64 + 1) << (64 - start % 64);
    result.set_word(i, w);
  }
  return result;
}

void insert(Bits& into, unsigned low, const Bits& value) {
  for (unsigned i = 0; i < value.width(); ++i) into.set(low + i, value.bit(i));
}

Bits invert(const Bits& a) {
  return word_by_word(a, a, [](Word x, Word) { return ~x; });
}

Bits zero_extend(const Bits& a, unsigned width) {
  Bits result(width, 0);
  for (unsigned i = 0; i < result.words(); ++i) result.set_word(i, a.word(i));
  return result;
}

Bits sign_extend(const Bits& a, unsigned width) {
  if (!a.bit(a.width() - 1)) return zero_extend(a, width);
  return invert(zero_extend(invert(a), width));
}

unsigned active_bits(const Bits& a) {
  unsigned bits = a.width();
  while (bits > 0 && !a.bit(bits - 1)) --bits;
  return bits;
}

Bits evaluate(const Node& node, std::span<const Bits> v) {
  const auto flag = [](bool value) { return Bits(1, value ? 1 : 0); };
  switch (node.op) {
    case Op::kAdd:
      return add(v[0], v[1], false);
    case Op::kSub:
      return add(v[0], invert(v[1]), true);
    case Op::kAddSub:
      return v[2].bit(0) ? add(v[0], invert(v[1]), true) : add(v[0], v[1], false);
    case Op::kMul:
      return multiply(v[0], v[1], node.width);
    case Op::kUDiv:
      return divide(v[0], v[1]);
    case Op::kAnd:
      return word_by_word(v[0], v[1], [](Word x, Word y) { return x & y; });
    case Op::kOr:
      return word_by_word(v[0], v[1], [](Word x, Word y) { return x | y; });
    case Op::kXor:
      return word_by_word(v[0], v[1], [](Word x, Word y) { return x ^ y; });
    case Op::kNot:
      return invert(v[0]);
    case Op::kShl:
      return shift_left(v[0], distance(v[1], node.width));
    case Op::kLShr:
      return shift_right(v[0], distance(v[1], node.width));
    case Op::kAShr:
      return shift_right_signed(v[0], distance(v[1], node.width));
    case Op::kEq:
      return flag(v[0] == v[1]);
    case Op::kULt:
      return flag(less(v[0], v[1]));
    case Op::kSLt:
      return flag(less(flip_sign(v[0]), flip_sign(v[1])));
    case Op::kMux:
      return v[0].bit(0) ? v[1] : v[2];
    case Op::kSlice:
      return extract(v[0], node.low, node.width);
    case Op::kConcat: {
      Bits result(node.width, 0);
      unsigned low = node.width;
      for (const Bits& part : v) insert(result, low -= part.width(), part);
      return result;
    }
    case Op::kSExt:
      return sign_extend(v[0], node.width);
    case Op::kClz:
      return Bits(node.width, v[0].width() - active_bits(v[0]));
    default:
      throw std::logic_error(std::string("evaluate: ") + op_name(node.op) + " is a source");
  }
}

}  // namespace hlsc
