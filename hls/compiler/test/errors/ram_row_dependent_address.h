// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/ram_row_dependent_address.h:13: error: RAM table can be read twice in one transaction; read the row once, or split the RAM
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<4>> in;
  hls::Out<hls::uint<4>> out;
  hls::Ram1R1W<hls::uint<4>, 16> table;
  void step() {
    const hls::uint<4> i = in.read();
    hls::uint<4> row = table.read(i);
    if (i.bit<3>()) row = table.read(row);
    out.write(row);
  }
};
}  // namespace errors
