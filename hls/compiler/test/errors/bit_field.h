// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/bit_field.h:9: error: member count is a bit-field, which hlsc cannot make a register; give it the type hls::uint<3>
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  unsigned count : 3 = 0;
  void step() { out.write(hls::uint<8>::from(in.read().to_u64() + count++)); }
};
}  // namespace errors
