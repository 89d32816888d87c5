// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/in_read_twice.h:9: error: In in is read twice in one transaction; read it once into a local variable
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<4>> in;
  hls::Out<hls::uint<5>> out;
  void step() { out.write(in.read() + in.read()); }
};
}  // namespace errors
