// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The writing of pixels and hit records to banks 3, 4 and 5. A core of one pipeline does it in its
// shading; where there are several, they share this unit. With a packet's last write the packet is
// free: what it wrote is in the banks before the frame can end.
#pragma once

#include <array>

#include "units/pixel.h"
#include "units/ray_generation.h"

namespace dynrt {

/// A step of a packet's shading: a pixel, a word of each half of a hit record, both or neither.
template <class C>
struct FrameWrite {
  bool has_pixel = false;
  bool has_hit = false;
  bool last = false;  ///< of the packet
  uint<20> pixel;     ///< word of bank 3
  typename PixelOf<C>::Bits colour;
  uint<20> hit;  ///< word of banks 4 and 5
  Word place;    ///< of a HitPlace
  Word surface;  ///< of a HitSurface
  FreePacket<C> packet;
  HLS_FIELDS(has_pixel, has_hit, last, pixel, colour, hit, place, surface, packet)
};

/// Ports to banks 3, 4 and 5 of the board.
using OutBank = hls::RamWrite<Word, kBankWords>;

template <class C>
struct FrameWriter {
  hls::In<FrameWrite<C>> write;
  hls::Out<FreePacket<C>> free;
  OutBank bank[3];
  HLS_PORTS(write, free, bank)

  void step() {
    const FrameWrite<C> w = write.read();
    if (w.has_pixel) bank[0].write(w.pixel, w.colour);
    if (w.has_hit) {
      bank[1].write(w.hit, w.place);
      bank[2].write(w.hit, w.surface);
    }
    if (w.last) free.write(w.packet);
  }
};

}  // namespace dynrt
