// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Pixels as a memory holds them, and as a display and the host see them.
#pragma once

#include <type_traits>

#include "hls/int.h"

namespace dynrt {

/// A pixel of 32 bits, as in a bank of SRAM: red lowest, the highest byte empty.
struct WordPixel {
  using Bits = hls::uint<32>;
  static constexpr unsigned kBytes = 4;
  static Bits of(hls::uint<32> colour) { return colour; }
  static hls::uint<24> colour(Bits pixel) { return pixel.trunc<24>(); }
};
/// A pixel of 16 bits: red in bits 4 to 0, green in 10 to 5, blue in 15 to 11. Of a colour it has
/// the highest bits. The colour that is seen has them below once more, so that black and white stay
/// what they are, and errors cancel out over the range.
struct HalfPixel {
  using Bits = hls::uint<16>;
  static constexpr unsigned kBytes = 2;
  static Bits of(hls::uint<32> colour) {
    return hls::concat(hls::concat(colour.bits<23, 19>(), colour.bits<15, 10>()),
                       colour.bits<7, 3>());
  }
  static hls::uint<24> colour(Bits pixel) {
    const auto red = hls::concat(pixel.bits<4, 0>(), pixel.bits<4, 2>());
    const auto green = hls::concat(pixel.bits<10, 5>(), pixel.bits<10, 9>());
    const auto blue = hls::concat(pixel.bits<15, 11>(), pixel.bits<15, 13>());
    return hls::concat(hls::concat(blue, green), red);
  }
};

/// That of configuration C.
template <class C>
using PixelOf = std::conditional_t<C::kPixelBits == 16, HalfPixel, WordPixel>;

}  // namespace dynrt
