// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/ram_read_after_write.h:13: error: RAM table can be read after it was written in the same transaction; read the row before the write and keep it in a local variable
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<4>> in;
  hls::Out<hls::uint<8>> out;
  hls::Ram1R1W<hls::uint<8>, 16> table;
  void step() {
    const hls::uint<4> i = in.read();
    table.write(i, hls::uint<8>(i));
    out.write(table.read(hls::next(i)));
  }
};
}  // namespace errors
