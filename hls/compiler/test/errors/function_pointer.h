// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/function_pointer.h:14: error: this call goes through a pointer or a virtual function; call the function by its name or make it a template parameter
#include "hls/ports.h"
namespace errors {
inline unsigned twice(unsigned x) { return 2 * x; }
inline unsigned square(unsigned x) { return x * x; }
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() {
    const unsigned x = static_cast<unsigned>(in.read().to_u64());
    unsigned (*const functions[2])(unsigned) = {twice, square};
    const unsigned result = functions[x % 2](x);
    out.write(hls::uint<8>::from(result));
  }
};
}  // namespace errors
