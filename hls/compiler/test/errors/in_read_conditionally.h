// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/in_read_conditionally.h:12: error: In right is read under a condition; a transaction reads one token from every In: read it first and use the token under the condition
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<4>> left;
  hls::In<hls::uint<4>> right;
  hls::Out<hls::uint<4>> out;
  void step() {
    const hls::uint<4> l = left.read();
    out.write(l.bit<0>() ? right.read() : l);
  }
};
}  // namespace errors
