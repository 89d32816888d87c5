// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Structs as tokens. A struct that travels through a channel or lies in a RAM names its fields
// once:
//     struct ListEntry { uint<6> packet; uint<17> matrix; HLS_FIELDS(packet, matrix) };
// HLS_FIELDS derives its width, its packing (first field in the lowest bits), its comparison and
// the names in a mismatch report. A leaf is a uint, a sint, a bool, an enum with an `enum_width`,
// or a type with `kLeafWidth`, `leaf_bits()` and `from_leaf_bits()` (a Float); leaves have at most
// 64 bits. Fields may be structs and std::arrays of all of these.
#pragma once

#include <array>
#include <string_view>
#include <type_traits>
#include <utility>

#include "hls/int.h"

/// Names the fields of a token, all of them, in packing order. hls_visit(visit) calls
/// visit(field...) with all of them at once: a std::tuple of references would take the compiler as
/// long as the unit.
#define HLS_FIELDS(...)                                                      \
  template <class Visit>                                                     \
  [[gnu::nodebug]] constexpr decltype(auto) hls_visit(Visit&& visit) {       \
    return visit(__VA_ARGS__);                                               \
  }                                                                          \
  template <class Visit>                                                     \
  [[gnu::nodebug]] constexpr decltype(auto) hls_visit(Visit&& visit) const { \
    return visit(__VA_ARGS__);                                               \
  }                                                                          \
  static constexpr std::string_view hls_field_names() { return #__VA_ARGS__; }

namespace hls {

/// Width of an enum in a token; specialise it beside the enum.
template <class E>
inline constexpr unsigned enum_width = 0;

/// A field that only some configurations have: an absent one takes no bits, reads as T{} and
/// ignores writes.
template <bool Present, class T>
struct OptionalField {
  T value{};
  constexpr OptionalField() = default;
  constexpr OptionalField(const T& t) : value(t) {}
  constexpr T get() const { return value; }
  HLS_FIELDS(value)
};
template <class T>
struct OptionalField<false, T> {
  constexpr OptionalField() = default;
  constexpr OptionalField(const T&) {}
  constexpr T get() const { return T{}; }
  template <class Visit>
  constexpr decltype(auto) hls_visit(Visit&& visit) const {
    return visit();
  }
  static constexpr std::string_view hls_field_names() { return {}; }
};

namespace detail {
template <class T>
struct is_uint : std::false_type {};
template <unsigned W>
struct is_uint<uint<W>> : std::true_type {};
template <class T>
struct is_sint : std::false_type {};
template <unsigned W>
struct is_sint<sint<W>> : std::true_type {};
template <class T>
struct is_array : std::false_type {};
template <class T, std::size_t N>
struct is_array<std::array<T, N>> : std::true_type {};
}  // namespace detail

template <class T>
concept Struct = requires { T::hls_field_names(); };
template <class T>
concept CustomLeaf = requires { T::kLeafWidth; };

/// Bits that a token of type T takes.
template <class T>
constexpr unsigned bit_width_of() {
  if constexpr (std::is_same_v<T, bool>) {
    return 1;
  } else if constexpr (std::is_enum_v<T>) {
    static_assert(enum_width<T> > 0, "specialise hls::enum_width for this enum");
    return enum_width<T>;
  } else if constexpr (detail::is_uint<T>::value || detail::is_sint<T>::value) {
    return T::kWidth;
  } else if constexpr (detail::is_array<T>::value) {
    return static_cast<unsigned>(std::tuple_size_v<T>) * bit_width_of<typename T::value_type>();
  } else if constexpr (CustomLeaf<T>) {
    return T::kLeafWidth;
  } else {
    static_assert(Struct<T>, "a token's struct names its fields with HLS_FIELDS");
    return decltype(std::declval<T&>().hls_visit([](auto&... field) {
      return std::integral_constant<
          unsigned, (0u + ... + bit_width_of<std::remove_cvref_t<decltype(field)>>())>{};
    }))::value;
  }
}

/// Calls visit(leaf, offset) for every leaf of a token, offset being its lowest bit's position.
template <class T, class Visit>
constexpr void for_each_leaf(T& token, Visit&& visit, unsigned offset = 0) {
  using Plain = std::remove_const_t<T>;
  if constexpr (detail::is_array<Plain>::value) {
    for (unsigned i = 0; i < std::tuple_size_v<Plain>; ++i) {
      for_each_leaf(token[i], visit, offset + i * bit_width_of<typename Plain::value_type>());
    }
  } else if constexpr (Struct<Plain>) {
    token.hls_visit([&](auto&... field) {
      ((for_each_leaf(field, visit, offset),
        offset += bit_width_of<std::remove_cvref_t<decltype(field)>>()),
       ...);
    });
  } else {
    static_assert(bit_width_of<Plain>() <= 64, "a leaf has at most 64 bits");
    visit(token, offset);
  }
}

/// to = from, leaf by leaf: a copy of the whole struct copies bytes and padding, and the optimiser
/// would lose track of the fields.
template <class T>
constexpr void copy_leaves(T& to, const T& from) {
  if constexpr (detail::is_array<T>::value) {
    for (unsigned i = 0; i < std::tuple_size_v<T>; ++i) copy_leaves(to[i], from[i]);
  } else if constexpr (Struct<T>) {
    to.hls_visit([&from](auto&... target) {
      from.hls_visit([&](const auto&... source) { (copy_leaves(target, source), ...); });
    });
  } else {
    to = from;
  }
}

/// The bits of one leaf, and the leaf of some bits.
template <class L>
constexpr uint<bit_width_of<L>()> leaf_to_bits(const L& leaf) {
  using Bits = uint<bit_width_of<L>()>;
  if constexpr (std::is_same_v<L, bool>) {
    return Bits::from(leaf);
  } else if constexpr (std::is_enum_v<L>) {
    return Bits::from(static_cast<unsigned>(leaf));
  } else if constexpr (detail::is_uint<L>::value) {
    return leaf;
  } else if constexpr (detail::is_sint<L>::value) {
    return leaf.as_unsigned();
  } else {
    return leaf.leaf_bits();
  }
}
template <class L>
constexpr L leaf_from_bits(uint<bit_width_of<L>()> bits) {
  if constexpr (std::is_same_v<L, bool>) {
    return bits.raw() != 0;
  } else if constexpr (std::is_enum_v<L>) {
    return static_cast<L>(static_cast<unsigned>(bits.raw()));
  } else if constexpr (detail::is_uint<L>::value) {
    return bits;
  } else if constexpr (detail::is_sint<L>::value) {
    return bits.as_signed();
  } else {
    return L::from_leaf_bits(bits);
  }
}

/// Word K of a token in 32-bit words of memory, of which no leaf crosses two.
template <unsigned K, class T>
constexpr uint<32> word_of(const T& token) {
  uint<32> word;
  for_each_leaf(token, [&word]<class L>(const L& leaf, unsigned offset) {
    const uint<32> bits = leaf_to_bits(leaf).template zext<32>();
    if (offset / 32 == K) word = word | bits << uint<5>::from(offset % 32);
  });
  return word;
}

}  // namespace hls
