// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/pointer_member.h:9: error: member best has type pointer, which is neither a port, an integer, an enum, a bool nor a struct or array of these; hlsc cannot make it a register
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  hls::uint<8>* best = nullptr;
  void step() { out.write(in.read()); }
};
}  // namespace errors
