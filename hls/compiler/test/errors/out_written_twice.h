// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/out_written_twice.h:12: error: Out out can be written twice in one transaction; make the writes exclude each other or add a second Out
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<4>> in;
  hls::Out<hls::uint<4>> out;
  void step() {
    const hls::uint<4> i = in.read();
    if (i.bit<0>()) out.write(i);
    if (i.bit<1>()) out.write(hls::next(i));
  }
};
}  // namespace errors
