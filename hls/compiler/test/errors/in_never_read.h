// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/in_never_read.h:8: error: In right is never read; a transaction reads one token from every In: read it or remove the member
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<4>> left;
  hls::In<hls::uint<4>> right;
  hls::Out<hls::uint<4>> out;
  void step() { out.write(left.read()); }
};
}  // namespace errors
