// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Sends a burst of pixels or hit records beat by beat to the memory behind the port. With its last
// burst a packet is free: its writes are on their way before the frame can end.
#pragma once

#include "units/burst_writer.h"
#include "units/repeated.h"

namespace dynrt {

template <class C>
struct MemoryWrite {
  hls::In<Repeated<WriteBurst<C>>> burst;
  hls::Out<PortWrite<C>> write;
  hls::Out<FreePacket<C>> free;
  HLS_PORTS(burst, write, free)

  void step() {
    const Repeated<WriteBurst<C>> b = burst.read();
    PortWrite<C> beat;
    beat.address = b.job.address & ~PortWrite<C>::within_beat();
    for (unsigned i = 0; i < kBeats; ++i) {
      if (kBeats == 1 || b.index == decltype(b.index)::from(i)) {
        beat.address = beat.address | uint<kMemoryAddressBits>::from(i * kBeatBytes<C>);
        put(beat, b.job, i);
      }
    }
    beat.left = uint<3>::from((b.job.repeat - b.index).raw());
    if (b.job.mask != decltype(b.job.mask)(0)) write.write(beat);
    if (b.last && b.job.ends) free.write(b.job.packet);
  }

 private:
  static constexpr unsigned kBeats = WriteBurst<C>::beats(kWriteBytes);
  static constexpr unsigned kHalves = kBeatBytes<C> / 2;
  static constexpr unsigned kBurstHalves = kWriteBytes / 2;
  static constexpr unsigned kPartHalves = WriteBurst<C>::kPartBytes / 2;

  /// The halves of beat `number`. One that is longer than the burst has it in each of its parts,
  /// and writes that of the address.
  static void put(PortWrite<C>& beat, const WriteBurst<C>& burst, unsigned number) {
    for (unsigned h = 0; h < kHalves; ++h) {
      const unsigned half = (number * kHalves + h) % kBurstHalves;
      const Word word = burst.data[half / 2];
      beat.data[h] = half % 2 == 0 ? word.template trunc<16>() : word.template bits<31, 16>();
      const bool here =
          kHalves <= kBurstHalves || bool(burst.address.template bit<4>()) == (h >= kBurstHalves);
      if (here && burst.mask.bit(half / kPartHalves)) beat.mask = beat.mask | bit(h);
    }
  }
  static decltype(PortWrite<C>::mask) bit(unsigned h) {
    return decltype(PortWrite<C>::mask)::from(1u << h);
  }
};

}  // namespace dynrt
