// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/bounds_check.h:11: error: __throw_out_of_range_fmt() is called, whose body hlsc cannot see; define it in a header or do without it
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    std::array<hls::uint<8>, 3> values{};
    out.write(values.at(in.read().to_u64()));
  }
};
}  // namespace errors
