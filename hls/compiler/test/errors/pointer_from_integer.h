// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/pointer_from_integer.h:10: error: this access goes through a pointer that hlsc cannot follow to one local variable or member; use an array and an index
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<32>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const auto* where = reinterpret_cast<const unsigned char*>(in.read().to_u64());
    out.write(hls::uint<8>::from(*where));
  }
};
}  // namespace errors
