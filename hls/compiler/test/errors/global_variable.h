// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/global_variable.h:10: error: the global variable calls is not constant; make it constexpr or a member of the unit
#include "hls/ports.h"
namespace errors {
inline unsigned calls = 0;
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() { out.write(hls::uint<8>::from(in.read().to_u64() + ++calls)); }
};
}  // namespace errors
