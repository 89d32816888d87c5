// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Gathers what the shading of a packet writes into bursts, for a memory behind the port. The
// shading goes ray by ray, row by row, and with each ray through the words of its hit record. So
// the pixels of a row of the packet become one burst, and two words of each half of a hit record
// another; rows begin at multiples of kPitchStep pixels, so that no burst crosses a beat.
#pragma once

#include <algorithm>
#include <array>

#include "units/frame_writer.h"
#include "units/memory_port.h"

namespace dynrt {

/// The words of 8 or 16 bytes, from the lowest address on.
inline constexpr unsigned kWriteBytes = 16;
template <class C>
struct WriteBurst {
  static constexpr unsigned beats(unsigned bytes) { return std::max(bytes / kBeatBytes<C>, 1u); }
  uint<hls::index_width(std::max(beats(kWriteBytes), 2u))> repeat;  ///< beats less one
  bool ends = false;                                                ///< the packet is written
  FreePacket<C> packet;
  uint<kMemoryAddressBits> address;  ///< of the first byte, aligned
  std::array<Word, kWriteBytes / 4> data;
  uint<kWriteBytes / 4> mask;  ///< the words to be written
  HLS_FIELDS(repeat, ends, packet, address, data, mask)
};

template <class C>
class FrameGather {
 public:
  static constexpr unsigned kColumns = packet_columns(kRays<C>);
  using Column = uint<hls::index_width(kColumns)>;

  /// Takes what the step of word `word` of a ray in `column` writes; its pixel comes with word 1.
  /// Every second word of a row's hit records completes a burst, and word 1 of its last ray, which
  /// is none of them, one of pixels. A packet's last step has a burst, if only an empty one.
  void take(const FrameWrite<C>& write, Column column, uint<2> word,
            hls::Out<WriteBurst<C>>& burst) {
    if (word == uint<2>(1)) {
      for (unsigned i = 0; i + 1 < kColumns; ++i) pixels_[i] = pixels_[i + 1];
      pixels_[kColumns - 1] = write.colour;
      inside_ = hls::concat(uint<1>(write.has_pixel), inside_).template bits<kColumns, 1>();
    }
    const bool row_ends = word == uint<2>(1) && column == Column::ones();
    const bool pair_ends = column.template bit<0>() != word.template bit<0>();
    WriteBurst<C> b = row_ends ? of_pixels(write.pixel) : of_hits(write);
    b.packet = write.packet;
    b.ends = write.last;
    if (b.mask == uint<4>(0)) b.repeat = 0;
    if (write.last || ((row_ends || pair_ends) && b.mask != uint<4>(0))) burst.write(b);
    before_ = write;
  }

 private:
  static constexpr unsigned kRowBytes = 4 * kColumns;
  using Repeats = decltype(WriteBurst<C>::repeat);
  static Repeats repeats(unsigned bytes) { return Repeats::from(WriteBurst<C>::beats(bytes) - 1); }

  /// The row that ends with pixel `last`. A beat that is longer has it in each of its parts.
  WriteBurst<C> of_pixels(uint<20> last) const {
    WriteBurst<C> b;
    b.repeat = repeats(kRowBytes);
    const auto row = last.template bits<19, hls::index_width(kColumns)>();
    b.address = hls::concat(uint<3>(kPixelsAt >> 22),
                            hls::concat(row, uint<hls::index_width(kRowBytes)>(0)));
    for (unsigned i = 0; i < b.data.size(); ++i) b.data[i] = pixels_[i % kColumns];
    if constexpr (kColumns == 4) {
      b.mask = inside_;
    } else if (kBeatBytes<C> > kRowBytes && row.template bit<0>()) {
      b.mask = hls::concat(inside_, uint<2>(0));
    } else {
      b.mask = inside_.template zext<4>();
    }
    return b;
  }
  /// A step's words, and those of the step before it.
  WriteBurst<C> of_hits(const FrameWrite<C>& write) const {
    WriteBurst<C> b;
    b.repeat = repeats(kWriteBytes);
    b.address = hls::concat(uint<2>(kHitsAt >> 23),
                            hls::concat(write.hit.template bits<19, 1>(), uint<4>(0)));
    b.data = {before_.place, before_.surface, write.place, write.surface};
    const auto twice = [](bool has) { return has ? uint<2>(3) : uint<2>(0); };
    b.mask = hls::concat(twice(write.has_hit), twice(before_.has_hit));
    return b;
  }

  std::array<Word, kColumns> pixels_;
  uint<kColumns> inside_;  ///< of the pixels
  FrameWrite<C> before_;
};

}  // namespace dynrt
