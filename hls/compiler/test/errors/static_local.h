// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/static_local.h:11: error: the global variable calls is not constant; make it constexpr or a member of the unit
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    static unsigned calls = 0;
    out.write(hls::uint<8>::from(in.read().to_u64() + ++calls));
  }
};
}  // namespace errors
