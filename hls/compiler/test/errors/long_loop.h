// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/long_loop.h:11: error: this loop has no bound that is known at compile time; give it a constant number of iterations (at most 1024) and leave it with break
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<16>> in;
  hls::Out<hls::uint<16>> out;
  void step() {
    hls::uint<16> value = in.read();
    for (unsigned i = 0; i < 5000; ++i) value = (value * value + hls::uint<16>(1)).trunc<16>();
    out.write(value);
  }
};
}  // namespace errors
