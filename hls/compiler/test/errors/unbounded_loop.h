// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/unbounded_loop.h:12: error: this loop has no bound that is known at compile time; give it a constant number of iterations (at most 1024) and leave it with break
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<32>> in;
  hls::Out<hls::uint<32>> out;
  void step() {
    unsigned long long value = in.read().to_u64();
    unsigned count = 0;
    while (value > 1) {
      value = value % 2 == 0 ? value / 2 : 3 * value + 1;
      ++count;
    }
    out.write(hls::uint<32>::from(count));
  }
};
}  // namespace errors
