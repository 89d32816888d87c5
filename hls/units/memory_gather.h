// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The beats of an answer from the memory port become one token. Beats come lowest address first,
// and those of one answer one after another.
#pragma once

#include "units/memory_port.h"

namespace dynrt {

template <class C>
struct MemoryGather {
  struct Beats {
    uint<hls::index_width(kReadBeats<C>)> number;
    std::array<BeatData<C>, kReadBeats<C>> data;
    HLS_FIELDS(number, data)
  };
  hls::In<PortBeat<C>> beat;
  hls::Out<PortLine<C>> line;
  hls::RegisterFile<Beats, 1> gathered;
  HLS_PORTS(beat, line)

  void step() {
    const PortBeat<C> b = beat.read();
    Beats beats = gathered.read(uint<1>(0));
    for (unsigned i = 0; i < kReadBeats<C>; ++i) {
      if (beats.number == decltype(beats.number)::from(i)) beats.data[i] = b.data;
    }
    beats.number = b.last ? decltype(beats.number)(0) : hls::next(beats.number);
    gathered.write(uint<1>(0), beats);
    PortLine<C> whole;
    whole.id = b.id;
    const auto half = [&beats](unsigned h) { return beats.data[h / kHalves][h % kHalves]; };
    for (unsigned w = 0; w < whole.data.size(); ++w) {
      whole.data[w] = hls::concat(half(2 * w + 1), half(2 * w));
    }
    if (b.last) line.write(whole);
  }

 private:
  static constexpr unsigned kHalves = kBeatBytes<C> / 2;  ///< of a beat, 16 bits each
};

}  // namespace dynrt
