// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: hlsc: error: clang rejects the unit:
// errors/syntax.h:10:37: error: expected ';' after expression
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() { out.write(in.read()) }
};
}  // namespace errors
