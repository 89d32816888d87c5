// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The picture of a display where it lies in a memory behind a port (units/memory_format.h): rows
// from kPixelsAt on, each of row_pitch(width) pixels. The display reads it in bursts, one after
// another, gaps at the ends of rows included.
#pragma once

#include "units/memory_format.h"
#include "units/scan_out.h"

namespace dynrt {

/// A pixel of 32 bits, as in a bank of SRAM: red lowest, the highest byte empty.
struct WordPixel {
  static constexpr unsigned kBytes = 4;
  static uint<24> colour(uint<32> pixel) { return pixel.trunc<24>(); }
};
/// A pixel of 16 bits: red in bits 4 to 0, green in 10 to 5, blue in 15 to 11. The colour has the
/// highest bits below once more, so that the brightest is 255.
struct HalfPixel {
  static constexpr unsigned kBytes = 2;
  static uint<24> colour(uint<16> pixel) {
    const auto red = hls::concat(pixel.bits<4, 0>(), pixel.bits<4, 2>());
    const auto green = hls::concat(pixel.bits<10, 5>(), pixel.bits<10, 9>());
    const auto blue = hls::concat(pixel.bits<15, 11>(), pixel.bits<15, 13>());
    return hls::concat(hls::concat(blue, green), red);
  }
};

/// Bytes of a burst, which is aligned; a controller of SDRAM takes no longer one.
inline constexpr unsigned kBurstBytes = 32;
/// Pixels of a burst. The picture's base is a multiple of them.
template <class Pixel>
inline constexpr unsigned kBurstPixels = kBurstBytes / Pixel::kBytes;

/// Bursts of a memory: the number of one, or of several.
using Bursts = uint<kMemoryAddressBits - 5>;
static_assert(kBurstBytes == 1u << 5);

/// Places for pixels in all rows, gaps included.
using PixelPlaces = uint<24>;
inline PixelPlaces picture_places(const ScanConfig& c) {
  const auto above = (c.width.template trunc<12>() + uint<2>(kPitchStep - 1)).template shr<2>();
  static_assert(kPitchStep == 4);
  const auto pitch = hls::concat(above.template trunc<11>(), uint<2>(0));
  return (pitch * c.height.template trunc<12>()).template trunc<24>();
}
template <class Pixel>
Bursts picture_bursts(const ScanConfig& c) {
  constexpr unsigned kShift = hls::index_width(kBurstPixels<Pixel>);
  const auto up = picture_places(c) + PixelPlaces(kBurstPixels<Pixel> - 1);
  return Bursts::from(up.template shr<kShift>().raw());
}

}  // namespace dynrt
