// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/bounds_check.h:11: error: the unit calls __throw_out_of_range_fmt(), but hlsc cannot see its body; define it in a header or do not call it
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
