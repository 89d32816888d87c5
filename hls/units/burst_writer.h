// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Burst writer: the end of the shading of a core with a memory behind the port. It gathers what the
// shading of a packet writes into bursts. The shading goes ray by ray, row by row, and with each
// ray through the words of its hit record. So the pixels of a row of the packet become one burst,
// and two words of each half of a hit record another; rows begin at multiples of kPitchStep pixels,
// so that no burst crosses a beat. A beat or a burst may be longer than what it writes: the mask
// says which pixels, or words, are written.
#pragma once

#include <algorithm>
#include <array>

#include "units/frame_writer.h"
#include "units/memory_port.h"
#include "units/packet.h"
#include "units/pipelines.h"
#include "units/pixel.h"
#include "units/repeated.h"

namespace dynrt {

/// The words of 4, 8 or 16 bytes, from the lowest address on.
inline constexpr unsigned kWriteBytes = 16;
template <class C>
struct WriteBurst {
  static constexpr unsigned kPartBytes = PixelOf<C>::kBytes;  ///< that are written or not
  static constexpr unsigned beats(unsigned bytes) { return std::max(bytes / kBeatBytes<C>, 1u); }
  uint<hls::index_width(std::max(beats(kWriteBytes), 2u))> repeat;  ///< beats less one
  bool ends = false;                                                ///< the packet is written
  FreePacket<C> packet;
  uint<kMemoryAddressBits> address;  ///< of the first byte, aligned
  std::array<Word, kWriteBytes / 4> data;
  uint<kWriteBytes / kPartBytes> mask;  ///< the parts to be written
  HLS_FIELDS(repeat, ends, packet, address, data, mask)
};

template <class C>
struct BurstWriter : PipelineOf<C> {
  static constexpr unsigned kColumns = packet_columns(kRays<C>);
  using Column = uint<hls::index_width(kColumns)>;

  hls::Out<WriteBurst<C>> burst;
  using PortsOfParts = hls::Parts<PipelineOf<C>>;
  HLS_PORTS(burst)

  static RayIndex<C> ray_of(RepeatCount<C> index) {
    return RayIndex<C>::from((index * uint<6>(43)).raw() >> 7);  // a third of an index below 64
  }
  static uint<2> word_of(RepeatCount<C> index) {
    return uint<2>::from((index + ray_of(index)).raw());  // less three times the ray, modulo 4
  }
  /// Pixels from a row of the picture to the next.
  static uint<11> pitch_of(const FrameRegisters<C>& config) {
    const uint<11> width = config.width.template trunc<11>();
    const auto more = (width + uint<2>(kPitchStep - 1)).template trunc<11>();
    return hls::concat(more.template bits<10, 2>(), uint<2>(0));
  }

  /// Takes what the step of word `word` of a ray writes; its pixel comes with word 1. Every second
  /// word of a row's hit records completes a burst, and word 1 of its last ray, which is none of
  /// them, one of pixels. A packet's last step has a burst, if only an empty one.
  void put(FrameWrite<C> write, RayIndex<C> ray, uint<2> word) {
    const Column column = ray.template trunc<Column::kWidth>();
    write.packet.pipeline = this->number();
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
    if (b.mask == Mask(0)) b.repeat = 0;
    if (write.last || ((row_ends || pair_ends) && b.mask != Mask(0))) burst.write(b);
    before_ = write;
  }

 private:
  using Pixel = PixelOf<C>;
  using Mask = decltype(WriteBurst<C>::mask);
  using Repeats = decltype(WriteBurst<C>::repeat);
  static constexpr unsigned kRowBytes = Pixel::kBytes * kColumns;
  /// Rows of a packet that a beat, or the burst, has room for.
  static constexpr unsigned kRowsOfBeat =
      std::max(std::min(kBeatBytes<C>, kWriteBytes) / kRowBytes, 1u);
  static Repeats repeats(unsigned bytes) { return Repeats::from(WriteBurst<C>::beats(bytes) - 1); }

  /// The row that ends with pixel `last`. A beat that is longer has it in each of its parts.
  WriteBurst<C> of_pixels(uint<20> last) const {
    WriteBurst<C> b;
    b.repeat = repeats(kRowBytes);
    const auto row = last.template bits<19, hls::index_width(kColumns)>();
    constexpr unsigned kByteBits = 20 + hls::index_width(Pixel::kBytes);  // within all pixels
    b.address = hls::concat(uint<kMemoryAddressBits - kByteBits>(kPixelsAt >> kByteBits),
                            hls::concat(row, uint<hls::index_width(kRowBytes)>(0)));
    for (unsigned i = 0; i < b.data.size(); ++i) b.data[i] = word(i);
    b.mask = inside_.template zext<Mask::kWidth>();
    if constexpr (kRowsOfBeat > 1) {
      const auto place = row.template trunc<hls::index_width(kRowsOfBeat)>();
      b.mask = b.mask << hls::concat(place, uint<hls::index_width(kColumns)>(0));
    }
    return b;
  }
  Word word(unsigned number) const {
    if constexpr (Pixel::kBytes == 4) {
      return pixels_[number % kColumns];
    } else {
      return hls::concat(pixels_[(2 * number + 1) % kColumns], pixels_[2 * number % kColumns]);
    }
  }
  /// A step's words, and those of the step before it.
  WriteBurst<C> of_hits(const FrameWrite<C>& write) const {
    WriteBurst<C> b;
    b.repeat = repeats(kWriteBytes);
    b.address = hls::concat(uint<2>(kHitsAt >> 23),
                            hls::concat(write.hit.template bits<19, 1>(), uint<4>(0)));
    b.data = {before_.place, before_.surface, write.place, write.surface};
    using Half = uint<Mask::kWidth / 2>;
    const auto all = [](bool has) { return has ? Half::ones() : Half(0); };
    b.mask = hls::concat(all(write.has_hit), all(before_.has_hit));
    return b;
  }

  std::array<typename Pixel::Bits, kColumns> pixels_;
  uint<kColumns> inside_;  ///< of the pixels
  FrameWrite<C> before_;
};

}  // namespace dynrt
