// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Colours and brightness as integers: a channel has 8 bits, 256 is full brightness.
#pragma once

#include "units/frame.h"
#include "units/packet.h"

namespace dynrt {

/// 0 to 256, in units of 1/256.
using Brightness = uint<9>;

/// min(|value|, 1) in units of 1/256, rounded down.
template <class Real>
Brightness in_256ths(Real value) {
  constexpr unsigned kMantissa = Real::kMantissaBits;
  const auto exponent = value.exponent();
  constexpr auto kOne = Real::one().exponent();
  if (!(exponent < kOne)) return 256;
  const auto significand = hls::concat(uint<1>(1), value.mantissa());
  const auto eighths = significand.template bits<kMantissa, kMantissa - 8>();
  return eighths >> (kOne - exponent).as_unsigned();
}

/// The colour of the hit surface.
template <class C>
uint<24> surface_colour(const SurfaceColour<C>& of_hit, const FrameRegisters<C>& frame) {
  if constexpr (C::kOneColour) {
    return frame.colour.get().template trunc<24>();
  } else {
    return of_hit;
  }
}

/// Channel 0 (red) to 2 (blue) of 0x00BBGGRR.
inline uint<8> channel(uint<24> colour, unsigned number) {
  return uint<8>::of_raw(static_cast<uint<8>::Raw>(colour.raw() >> (8 * number)));
}

inline uint<8> scaled(uint<8> channel, Brightness brightness) {
  return (channel * brightness).template bits<15, 8>();
}
inline uint<24> eye_light(uint<24> colour, Brightness brightness) {
  return hls::concat(
      scaled(channel(colour, 2), brightness),
      hls::concat(scaled(channel(colour, 1), brightness), scaled(channel(colour, 0), brightness)));
}
inline Brightness product(Brightness a, Brightness b) { return (a * b).template bits<16, 8>(); }

}  // namespace dynrt
