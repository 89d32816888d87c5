// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The picture of a display where it lies in a memory behind a port (units/memory_format.h): rows
// from kPixelsAt on, each of row_pitch(width) pixels. The display reads it in bursts, one after
// another, gaps at the ends of rows included.
#pragma once

#include "units/memory_format.h"
#include "units/pixel.h"
#include "units/scan_out.h"

namespace dynrt {

/// Bytes of a burst, which is aligned; a controller of SDRAM takes no longer one.
inline constexpr unsigned kBurstBytes = 32;
/// Bursts that rtl/display/picture_stream.v has room for.
inline constexpr unsigned kPictureAhead = 64;
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
