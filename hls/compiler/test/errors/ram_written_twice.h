// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/ram_written_twice.h:12: error: RAM table can be written twice in one transaction; put the row together and write it once
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<4>> in;
  hls::RamWrite<hls::uint<8>, 16> table;
  void step() {
    const hls::uint<4> i = in.read();
    table.write(0, hls::uint<8>(i));
    if (i.bit<0>()) table.write(i, 7);
  }
};
}  // namespace errors
