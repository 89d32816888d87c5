// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/dynamic_memory.h:11: error: memory is allocated dynamically; use a local array or a RAM member
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const auto size = in.read().to_u64();
    auto* values = new hls::uint<8>[size];
    for (unsigned i = 0; i < 4; ++i) values[i] = hls::uint<8>::from(i);
    out.write(values[size / 2]);
    delete[] values;
  }
};
}  // namespace errors
