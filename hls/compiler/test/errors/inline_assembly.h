// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/inline_assembly.h:11: error: inline assembly cannot be lowered; write it in C++
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    unsigned x = static_cast<unsigned>(in.read().to_u64());
    asm("addl %0, %0" : "+r"(x));
    out.write(hls::uint<8>::from(x));
  }
};
}  // namespace errors
