// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/not_constant.h: error: the type errors::Unit cannot be used as a unit; give --unit the full name of a complete type that errors/not_constant.h defines. clang says: variable does not have a constant initializer
#include "hls/ports.h"
namespace errors {
inline unsigned first() { return 1; }
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  unsigned count = first();
  void step() { out.write(hls::uint<8>::from(in.read().to_u64() + count++)); }
};
}  // namespace errors
