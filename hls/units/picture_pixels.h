// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Finds the pixels in what the memory gives of a picture: drops the gaps at the ends of rows and
// what the last burst has behind the picture, and marks the first pixel, by which the display finds
// the beginning of a picture. A transaction is one place for a pixel. State: the place, its column.
#pragma once

#include "hls/ports.h"
#include "units/picture_format.h"

namespace dynrt {

struct PicturePixel {
  uint<24> colour;  ///< red lowest
  bool first = false;
  HLS_FIELDS(colour, first)
};

template <class Pixel>
struct PicturePixels {
  hls::In<uint<8 * Pixel::kBytes>> place;
  hls::Config<ScanConfig> config;
  hls::Out<PicturePixel> pixel;
  HLS_PORTS(place, config, pixel)

  void step() {
    const uint<8 * Pixel::kBytes> bits = place.read();
    const ScanConfig c = config.get();
    constexpr PixelPlaces kInBurst(kBurstPixels<Pixel> - 1);
    const PixelPlaces last_of_rows = before(picture_places(c));
    const PixelPlaces last = last_of_rows | kInBurst;
    const auto last_column = (before(c.width.template trunc<12>()) | uint<12>(kPitchStep - 1));

    const bool behind = behind_;
    if (!behind && column_ < c.width.template trunc<12>()) {
      pixel.write({Pixel::colour(bits), number_ == PixelPlaces(0)});
    }
    const bool all_end = number_ == last;
    behind_ = !all_end && (behind || number_ == last_of_rows);
    column_ = all_end || column_ == last_column ? uint<12>(0) : hls::next(column_);
    number_ = all_end ? PixelPlaces(0) : hls::next(number_);
  }

 private:
  template <unsigned W>
  static uint<W> before(uint<W> value) {
    return (value + uint<W>::ones()).template trunc<W>();
  }

  PixelPlaces number_;
  uint<12> column_;
  bool behind_ = false;  ///< the picture
};

/// As it is lowered with the core of configuration C.
template <class C>
using PicturePixelsOf = PicturePixels<PixelOf<C>>;

}  // namespace dynrt
