// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens of up to 128 bits as one integer, and back: the packing of fields.h as a value.
#pragma once

#include "hls/fields.h"

namespace hls {

template <class T>
constexpr uint<bit_width_of<T>()> to_bits(const T& token) {
  using Bits = uint<bit_width_of<T>()>;
  using Raw = typename Bits::Raw;
  Raw bits = 0;
  for_each_leaf(token, [&bits](const auto& leaf, unsigned offset) {
    bits = static_cast<Raw>(bits |
                            static_cast<Raw>(static_cast<Raw>(leaf_to_bits(leaf).raw()) << offset));
  });
  return Bits::of_raw(bits);
}

template <class T>
constexpr T from_bits(uint<bit_width_of<T>()> bits) {
  T token{};
  for_each_leaf(token, [bits]<class L>(L& leaf, unsigned offset) {
    using LeafBits = uint<bit_width_of<L>()>;
    leaf = leaf_from_bits<L>(
        LeafBits::of_raw(static_cast<typename LeafBits::Raw>(bits.raw() >> offset)));
  });
  return token;
}

}  // namespace hls
