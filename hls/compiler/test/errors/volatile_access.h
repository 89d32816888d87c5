// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/volatile_access.h:10: error: volatile accesses cannot be lowered; make the variable a plain local or a member
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    volatile unsigned x = static_cast<unsigned>(in.read().to_u64());
    out.write(hls::uint<8>::from(x));
  }
};
}  // namespace errors
