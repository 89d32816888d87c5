// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Bank writer: the end of the shading of a core that has its banks to itself (thesis chapter 7). A
// ray takes three clocks: in the first two rounds over a packet's rays the pixels of every second
// ray go to bank 3, so that the bank has a clock for the display between two pixels; in all three,
// one word of each ray's hit record goes to each of banks 4 and 5.
#pragma once

#include "units/frame.h"
#include "units/frame_writer.h"
#include "units/packet.h"
#include "units/ray_generation.h"
#include "units/repeated.h"

namespace dynrt {

/// The order in which a core with banks writes a packet: the first word of all rays, then the
/// second, then the third; rows of pixels follow one another without a gap.
template <class C>
struct RoundByRound {
  static RayIndex<C> ray_of(RepeatCount<C> index) {
    return index.template bits<kRayBits<C> - 1, 0>();
  }
  static uint<2> word_of(RepeatCount<C> index) {
    return index.template bits<kRayBits<C> + 1, kRayBits<C>>();
  }
  /// Pixels from a row of the picture to the next.
  static uint<11> pitch_of(const FrameRegisters<C>& config) {
    return config.width.template trunc<11>();
  }
  /// Whether a ray's pixel is written in this round.
  static bool is_pixels_turn(RayIndex<C> ray, uint<2> word) {
    return word == ray.template bits<0, 0>().template zext<2>();
  }
};

template <class C>
struct BankWriter : RoundByRound<C> {
  hls::Out<FreePacket<C>> free;
  OutBank bank[3];
  HLS_PORTS(free, bank)

  void put(const FrameWrite<C>& w, RayIndex<C> ray, uint<2> word) {
    if (w.has_pixel && this->is_pixels_turn(ray, word)) bank[0].write(w.pixel, w.colour);
    if (w.has_hit) {
      bank[1].write(w.hit, w.place);
      bank[2].write(w.hit, w.surface);
    }
    if (w.last) free.write(w.packet);
  }
};

}  // namespace dynrt
