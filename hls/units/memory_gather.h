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
  hls::In<PortBeat<C>> beat;
  hls::Out<PortLine<C>> line;
  hls::RegisterFile<std::array<BeatData<C>, kReadBeats<C>>, 1> latest;
  HLS_PORTS(beat, line)

  void step() {
    const PortBeat<C> b = beat.read();
    // The beats move up by one, so that no place is chosen in the loop.
    const auto before = latest.read(uint<1>(0));
    std::array<BeatData<C>, kReadBeats<C>> beats;
    for (unsigned i = 0; i + 1 < kReadBeats<C>; ++i) beats[i] = before[i + 1];
    beats[kReadBeats<C> - 1] = b.data;
    latest.write(uint<1>(0), beats);
    PortLine<C> whole;
    whole.id = b.id;
    for (unsigned w = 0; w < whole.data.size(); ++w) {
      whole.data[w] = hls::concat(half(beats, b.id.kind, 2 * w + 1), half(beats, b.id.kind, 2 * w));
    }
    if (b.last) line.write(whole);
  }

 private:
  static constexpr unsigned kHalves = kBeatBytes<C> / 2;  ///< of a beat, 16 bits each

  /// A half of an answer of a kind, whose beats are the latest; beyond its end, any.
  static uint<16> half(const std::array<BeatData<C>, kReadBeats<C>>& beats, MemoryKind kind,
                       unsigned number) {
    const auto of = [&](MemoryKind of_line) {
      const unsigned from = kReadBeats<C> - 1 - last_beat<C>(of_line);
      const unsigned at = from + number / kHalves;
      return beats[at < kReadBeats<C> ? at : kReadBeats<C> - 1][number % kHalves];
    };
    return of_kind(kind, of(MemoryKind::kNode), of(MemoryKind::kList), of(MemoryKind::kColumn));
  }
};

}  // namespace dynrt
