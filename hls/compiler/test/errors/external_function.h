// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/external_function.h:11: error: the unit calls elsewhere(), but hlsc cannot see its body; define it in a header or do not call it
#include "hls/ports.h"
namespace errors {
unsigned elsewhere(unsigned x);
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    out.write(hls::uint<8>::from(elsewhere(static_cast<unsigned>(in.read().to_u64()))));
  }
};
}  // namespace errors
