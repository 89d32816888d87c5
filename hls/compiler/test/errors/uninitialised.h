// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/uninitialised.h:12: error: this condition depends on a variable that was never set; give it an initial value
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const auto x = in.read();
    bool found;
    if (found) out.write(x);
  }
};
}  // namespace errors
