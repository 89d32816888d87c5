// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/recursion.h:15: error: sum() calls itself; write it as a loop with a constant bound or as a template that ends
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;

  static unsigned sum(unsigned n);
  void step() { out.write(hls::uint<8>::from(sum(static_cast<unsigned>(in.read().to_u64())))); }
};
inline unsigned Unit::sum(unsigned n) {
  if (n == 0) return 0;
  return n + sum(n - 1);
}
}  // namespace errors
