// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/ram_read_twice.h:12: error: RAM table can be read twice in one transaction; read the row once, or split the RAM
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<4>> in;
  hls::Out<hls::uint<9>> out;
  hls::Ram1R1W<hls::uint<8>, 16> table;
  void step() {
    const hls::uint<4> i = in.read();
    out.write(table.read(i) + table.read(hls::next(i)));
  }
};
}  // namespace errors
