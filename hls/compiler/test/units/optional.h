// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A unit with a port, a RAM and a field that only some of its configurations have.
#pragma once

#include "hls/ports.h"

namespace samples {

template <bool Tagged>
struct OptionalToken {
  hls::uint<6> value;
  hls::OptionalField<Tagged, hls::uint<4>> tag;
  HLS_FIELDS(value, tag)
};

template <bool Tagged>
struct Optional {
  hls::In<OptionalToken<Tagged>> in;
  hls::OptionalPort<Tagged, hls::In<hls::uint<4>>> mask;
  hls::Out<OptionalToken<Tagged>> out;
  hls::OptionalPort<Tagged, hls::RegisterFile<hls::uint<4>, 64>> tags;
  HLS_PORTS(in, mask, out)

  void step() {
    OptionalToken<Tagged> token = in.read();
    if constexpr (Tagged) {
      const hls::uint<4> before = tags.read(token.value);
      tags.write(token.value, token.tag.get());
      token.tag = before ^ mask.read();
    }
    token.value = token.value ^ token.tag.get().template zext<6>();
    out.write(token);
  }
};

}  // namespace samples
