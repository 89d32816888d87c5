// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// uint<W> and sint<W>: integers of exactly W bits on clang's _BitInt, with explicit result widths.
// A sum is one bit wider than its wider operand, a product as wide as both together, a difference
// signed and one bit wider; nothing narrows unless trunc<N>() says so, and no operand is ever
// promoted to int. Widening is implicit. W is 1 to 128 (sint: 2 to 128).
#pragma once

#include <type_traits>

namespace hls {

template <unsigned W>
class sint;

namespace detail {
/// Never defined: reaching it in a constant expression is the error message.
void literal_does_not_fit();
}  // namespace detail

constexpr unsigned max_width(unsigned a, unsigned b) { return a > b ? a : b; }

/// Bits needed to hold the values 0 .. count - 1 (at least one).
constexpr unsigned index_width(unsigned long long count) {
  unsigned width = 1;
  while (width < 64 && (1ull << width) < count) ++width;
  return width;
}

template <unsigned W>
class uint {
 public:
  static constexpr unsigned kWidth = W;
  using Raw = unsigned _BitInt(W);

  constexpr uint() = default;
  /// A literal; one that does not fit is a compile-time error.
  consteval uint(int literal) : raw_(static_cast<Raw>(literal)) {
    if (literal < 0 || static_cast<unsigned long long>(raw_) != static_cast<unsigned>(literal)) {
      detail::literal_does_not_fit();
    }
  }
  constexpr uint(bool b)
    requires(W == 1)
      : raw_(b) {}
  template <unsigned V>
    requires(V < W)
  constexpr uint(uint<V> narrower) : raw_(narrower.raw()) {}
  /// The low W bits of any integer.
  static constexpr uint from(unsigned _BitInt(128) value) {
    uint u;
    u.raw_ = static_cast<Raw>(value);
    return u;
  }
  static constexpr uint of_raw(Raw raw) {
    uint u;
    u.raw_ = raw;
    return u;
  }
  static constexpr uint ones() { return of_raw(static_cast<Raw>(~Raw{0})); }

  constexpr Raw raw() const { return raw_; }
  constexpr explicit operator bool() const
    requires(W == 1)
  {
    return raw_ != 0;
  }
  constexpr unsigned long long to_u64() const
    requires(W <= 64)
  {
    return static_cast<unsigned long long>(raw_);
  }

  template <unsigned N>
    requires(N <= W)
  constexpr uint<N> trunc() const {
    return uint<N>::of_raw(static_cast<unsigned _BitInt(N)>(raw_));
  }
  template <unsigned N>
    requires(N >= W)
  constexpr uint<N> zext() const {
    return uint<N>::of_raw(static_cast<unsigned _BitInt(N)>(raw_));
  }
  /// Bits Hi down to Lo, both included.
  template <unsigned Hi, unsigned Lo>
    requires(Hi >= Lo && Hi < W)
  constexpr uint<Hi - Lo + 1> bits() const {
    return uint<Hi - Lo + 1>::of_raw(static_cast<unsigned _BitInt(Hi - Lo + 1)>(raw_ >> Lo));
  }
  template <unsigned I>
    requires(I < W)
  constexpr bool bit() const {
    return ((raw_ >> I) & Raw{1}) != 0;
  }
  constexpr bool bit(unsigned i) const { return ((raw_ >> i) & Raw{1}) != 0; }
  constexpr sint<W + 1> to_signed() const;
  constexpr sint<W> as_signed() const
    requires(W >= 2);

  constexpr uint operator~() const { return of_raw(static_cast<Raw>(~raw_)); }
  /// Shifts keep the width; a shift by W or more is zero.
  template <unsigned S>
  constexpr uint operator<<(uint<S> by) const {
    return by.reaches(W) ? uint{} : of_raw(static_cast<Raw>(raw_ << by.raw()));
  }
  template <unsigned S>
  constexpr uint operator>>(uint<S> by) const {
    return by.reaches(W) ? uint{} : of_raw(static_cast<Raw>(raw_ >> by.raw()));
  }
  template <unsigned K>
    requires(K < W)
  constexpr uint shl() const {
    return of_raw(static_cast<Raw>(raw_ << K));
  }
  template <unsigned K>
    requires(K < W)
  constexpr uint shr() const {
    return of_raw(static_cast<Raw>(raw_ >> K));
  }
  /// True if the value is at least `limit`; false at compile time where W bits cannot reach it.
  constexpr bool reaches(unsigned limit) const {
    if constexpr (W < 32) {
      if ((1u << W) <= limit) return false;
    }
    return static_cast<unsigned _BitInt(W + 32)>(raw_) >= limit;
  }

  friend constexpr uint operator&(uint a, uint b) {
    return of_raw(static_cast<Raw>(a.raw_ & b.raw_));
  }
  friend constexpr uint operator|(uint a, uint b) {
    return of_raw(static_cast<Raw>(a.raw_ | b.raw_));
  }
  friend constexpr uint operator^(uint a, uint b) {
    return of_raw(static_cast<Raw>(a.raw_ ^ b.raw_));
  }
  friend constexpr bool operator==(uint a, uint b) { return a.raw_ == b.raw_; }
  friend constexpr bool operator!=(uint a, uint b) { return a.raw_ != b.raw_; }
  friend constexpr bool operator<(uint a, uint b) { return a.raw_ < b.raw_; }
  friend constexpr bool operator<=(uint a, uint b) { return a.raw_ <= b.raw_; }
  friend constexpr bool operator>(uint a, uint b) { return a.raw_ > b.raw_; }
  friend constexpr bool operator>=(uint a, uint b) { return a.raw_ >= b.raw_; }

 private:
  Raw raw_ = 0;
};

template <unsigned W>
class sint {
  static_assert(W >= 2, "a signed integer has at least two bits");

 public:
  static constexpr unsigned kWidth = W;
  using Raw = signed _BitInt(W);

  constexpr sint() = default;
  consteval sint(int literal) : raw_(static_cast<Raw>(literal)) {
    if (static_cast<long long>(raw_) != literal) detail::literal_does_not_fit();
  }
  template <unsigned V>
    requires(V < W)
  constexpr sint(sint<V> narrower) : raw_(narrower.raw()) {}
  static constexpr sint of_raw(Raw raw) {
    sint s;
    s.raw_ = raw;
    return s;
  }

  constexpr Raw raw() const { return raw_; }
  constexpr long long to_s64() const
    requires(W <= 64)
  {
    return static_cast<long long>(raw_);
  }
  constexpr bool negative() const { return raw_ < 0; }
  /// The W bits as they are.
  constexpr uint<W> as_unsigned() const {
    return uint<W>::of_raw(static_cast<unsigned _BitInt(W)>(raw_));
  }
  template <unsigned N>
    requires(N <= W)
  constexpr sint<N> trunc() const {
    return sint<N>::of_raw(static_cast<signed _BitInt(N)>(raw_));
  }

  friend constexpr bool operator==(sint a, sint b) { return a.raw_ == b.raw_; }
  friend constexpr bool operator!=(sint a, sint b) { return a.raw_ != b.raw_; }
  friend constexpr bool operator<(sint a, sint b) { return a.raw_ < b.raw_; }
  friend constexpr bool operator<=(sint a, sint b) { return a.raw_ <= b.raw_; }
  friend constexpr bool operator>(sint a, sint b) { return a.raw_ > b.raw_; }
  friend constexpr bool operator>=(sint a, sint b) { return a.raw_ >= b.raw_; }

 private:
  Raw raw_ = 0;
};

template <unsigned W>
constexpr sint<W + 1> uint<W>::to_signed() const {
  return sint<W + 1>::of_raw(static_cast<signed _BitInt(W + 1)>(raw_));
}
template <unsigned W>
constexpr sint<W> uint<W>::as_signed() const
  requires(W >= 2)
{
  return sint<W>::of_raw(static_cast<signed _BitInt(W)>(raw_));
}

template <unsigned A, unsigned B>
constexpr auto operator+(uint<A> a, uint<B> b) {
  constexpr unsigned kSum = max_width(A, B) + 1;
  using Raw = unsigned _BitInt(kSum);
  return uint<kSum>::of_raw(
      static_cast<Raw>(static_cast<Raw>(a.raw()) + static_cast<Raw>(b.raw())));
}
template <unsigned A, unsigned B>
constexpr auto operator-(uint<A> a, uint<B> b) {
  constexpr unsigned kDifference = max_width(A, B) + 1;
  using Raw = signed _BitInt(kDifference);
  return sint<kDifference>::of_raw(
      static_cast<Raw>(static_cast<Raw>(a.raw()) - static_cast<Raw>(b.raw())));
}
template <unsigned A, unsigned B>
constexpr auto operator*(uint<A> a, uint<B> b) {
  using Raw = unsigned _BitInt(A + B);
  return uint<A + B>::of_raw(
      static_cast<Raw>(static_cast<Raw>(a.raw()) * static_cast<Raw>(b.raw())));
}
/// Quotient, as wide as the dividend; division by zero is undefined.
template <unsigned A, unsigned B>
constexpr uint<A> operator/(uint<A> a, uint<B> b) {
  using Raw = unsigned _BitInt(max_width(A, B));
  return uint<A>::of_raw(
      static_cast<unsigned _BitInt(A)>(static_cast<Raw>(a.raw()) / static_cast<Raw>(b.raw())));
}
template <unsigned A, unsigned B>
constexpr auto operator+(sint<A> a, sint<B> b) {
  constexpr unsigned kSum = max_width(A, B) + 1;
  using Raw = signed _BitInt(kSum);
  return sint<kSum>::of_raw(
      static_cast<Raw>(static_cast<Raw>(a.raw()) + static_cast<Raw>(b.raw())));
}
template <unsigned A, unsigned B>
constexpr auto operator-(sint<A> a, sint<B> b) {
  constexpr unsigned kDifference = max_width(A, B) + 1;
  using Raw = signed _BitInt(kDifference);
  return sint<kDifference>::of_raw(
      static_cast<Raw>(static_cast<Raw>(a.raw()) - static_cast<Raw>(b.raw())));
}
template <unsigned A, unsigned B>
constexpr auto operator*(sint<A> a, sint<B> b) {
  using Raw = signed _BitInt(A + B);
  return sint<A + B>::of_raw(
      static_cast<Raw>(static_cast<Raw>(a.raw()) * static_cast<Raw>(b.raw())));
}

/// {high, low}: the first operand's bits above the second's.
template <unsigned A, unsigned B>
constexpr uint<A + B> concat(uint<A> high, uint<B> low) {
  using Raw = unsigned _BitInt(A + B);
  return uint<A + B>::of_raw(static_cast<Raw>(static_cast<Raw>(static_cast<Raw>(high.raw()) << B) |
                                              static_cast<Raw>(low.raw())));
}

/// c ? yes : no, as a value: both sides are computed, nothing branches.
template <unsigned W>
constexpr uint<W> select(bool c, uint<W> yes, uint<W> no) {
  return uint<W>::of_raw(c ? yes.raw() : no.raw());
}

/// Wrapping increment, for counters and addresses.
template <unsigned W>
constexpr uint<W> next(uint<W> value) {
  return uint<W>::of_raw(static_cast<unsigned _BitInt(W)>(value.raw() + typename uint<W>::Raw{1}));
}

/// Number of zero bits above the highest one; W where there is none.
template <unsigned W>
constexpr uint<index_width(W + 1)> count_leading_zeros(uint<W> value) {
  constexpr unsigned kResult = index_width(W + 1);
  return uint<kResult>::from(
      static_cast<unsigned>(__builtin_clzg(value.raw(), static_cast<int>(W))));
}

}  // namespace hls
