// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/atomic_access.h:11: error: atomic operations cannot be lowered; use a plain member, as a transaction is atomic by itself
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    unsigned x = static_cast<unsigned>(in.read().to_u64());
    __atomic_add_fetch(&x, 1, __ATOMIC_SEQ_CST);
    out.write(hls::uint<8>::from(x));
  }
};
}  // namespace errors
