// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/double_arithmetic.h:10: error: double arithmetic cannot be lowered; use hls::Float<E, M> or integers
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const double x = static_cast<double>(in.read().to_u64());
    out.write(hls::uint<8>::from(static_cast<unsigned>(x / 3)));
  }
};
}  // namespace errors
