// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The memory format of one float R.
#pragma once

#include "configs/shipped.h"
#include "hls/cast.h"
#include "host/format/memory_format.h"

namespace dynrt::host {

namespace detail {

template <class R>
struct Packing {
  static constexpr unsigned kWordBits = SceneWord<R>::kWidth;
  static_assert(kWordBits <= 64 && R::kLeafWidth <= 32);

  static std::uint32_t bits(double number) {
    return static_cast<std::uint32_t>(R::from_double(number).bits().to_u64());
  }
  static double number(std::uint32_t bits) { return from(bits).to_double(); }

  static std::array<MemoryWord, 2> pack_node(const MemoryNode& node) {
    const auto all = hls::to_bits(Node<R>{node.kind, R::from_double(node.split),
                                          Address::from(node.left), Address::from(node.right)});
    const auto words = all.template zext<2 * kWordBits>();
    return {words.template trunc<kWordBits>().to_u64(),
            words.template bits<2 * kWordBits - 1, kWordBits>().to_u64()};
  }
  static MemoryNode unpack_node(const std::array<MemoryWord, 2>& words) {
    const auto all = hls::concat(SceneWord<R>::from(words[1]), SceneWord<R>::from(words[0]));
    const auto node = hls::from_bits<Node<R>>(all.template trunc<hls::bit_width_of<Node<R>>()>());
    return {node.kind, node.split.to_double(), static_cast<std::uint32_t>(node.left.to_u64()),
            static_cast<std::uint32_t>(node.right.to_u64())};
  }

  static std::array<MemoryWord, 3> pack_column(const MemoryColumn& column) {
    std::array<MemoryWord, 3> words;
    for (unsigned r = 0; r < 3; ++r) {
      words[r] = hls::to_bits(MatrixWord<R>{R::from_double(column.value[r]),
                                            Spare::from(column.spare >> (r * Spare::kWidth))})
                     .to_u64();
    }
    return words;
  }
  static MemoryColumn unpack_column(const std::array<MemoryWord, 3>& words) {
    MemoryColumn column;
    for (unsigned r = 0; r < 3; ++r) {
      const auto word = hls::from_bits<MatrixWord<R>>(Used::from(words[r]));
      column.value[r] = word.value.to_double();
      column.spare |= word.spare.to_u64() << (r * Spare::kWidth);
    }
    return column;
  }
  static MemoryColumn box_column(const std::array<double, 3>& low,
                                 const std::array<double, 3>& high) {
    std::array<MemoryWord, 3> words;
    for (unsigned axis = 0; axis < 3; ++axis) {
      words[axis] =
          hls::to_bits(Slab<R>{-bound_above(-low[axis]), bound_above(high[axis])}).to_u64();
    }
    return unpack_column(words);
  }

 private:
  /// The smallest that is not below. Conversion goes towards zero, which is no number.
  static Bound<R> bound_above(double x) {
    const auto bound = Bound<R>::from_double(x);
    if (bound.to_double() >= x) return bound;
    return bound.sign() ? -bound : bound.template moved_up<1>();
  }
  using Spare = uint<kSpareBits<R>>;
  using Used = uint<hls::bit_width_of<MatrixWord<R>>()>;
  static R from(std::uint32_t bits) { return R::from_bits(R::Bits::from(bits)); }
};

}  // namespace detail

template <class R>
inline constexpr MemoryFormat kMemoryFormatOf = {
    .exponent_bits = R::kExponentBits,
    .mantissa_bits = R::kMantissaBits,
    .rounding = R::kRounding,
    .word_bits = detail::Packing<R>::kWordBits,
    .smallest = R::smallest().to_double(),
    .largest = R::largest().to_double(),
    .bits = detail::Packing<R>::bits,
    .number = detail::Packing<R>::number,
    .pack_node = detail::Packing<R>::pack_node,
    .unpack_node = detail::Packing<R>::unpack_node,
    .pack_column = detail::Packing<R>::pack_column,
    .unpack_column = detail::Packing<R>::unpack_column,
    .box_column = detail::Packing<R>::box_column,
};

/// The format of the first configuration of hls/configs/configs.json, for figures of a scene
/// without a board.
inline constexpr const MemoryFormat& kShippedFormat = kMemoryFormatOf<config::shipped::Real>;

}  // namespace dynrt::host
