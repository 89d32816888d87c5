// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: hlsc: error: clang rejects the unit:
// errors/exceptions.h:12:31: error: cannot use 'throw' with exceptions disabled
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const auto x = in.read();
    if (x == hls::uint<8>(0)) throw 1;
    out.write(x);
  }
};
}  // namespace errors
