// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A small unit of your own: smooths the samples of several channels, y += weight (x - y), in your
// own 12-bit float.
#pragma once

#include "hls/float.h"
#include "hls/ports.h"

namespace example {

using Real = hls::Float<5, 6>;
using Channel = hls::uint<3>;

struct Sample {
  Channel channel;
  bool first = false;  ///< no sample came before
  Real value;
  HLS_FIELDS(channel, first, value)
};
struct Smoothed {
  Channel channel;
  Real value;
  HLS_FIELDS(channel, value)
};

struct Smooth {
  hls::In<Sample> sample;
  hls::Out<Smoothed> smoothed;
  hls::Config<Real> weight;
  hls::Ram1R1W<Real, 8> state;
  HLS_PORTS(sample, smoothed, weight)

  void step() {
    const Sample s = sample.read();
    const Real before = state.read(s.channel);
    const Real after = s.first ? s.value : before + weight.get() * (s.value - before);
    state.write(s.channel, after);
    smoothed.write(Smoothed{s.channel, after});
  }
};

}  // namespace example
