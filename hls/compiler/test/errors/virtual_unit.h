// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/virtual_unit.h:6: error: the unit has virtual functions, but a unit is a plain class; use templates instead
#include "hls/ports.h"
namespace errors {
struct Unit {
  virtual unsigned constant() const { return 1; }
  hls::In<hls::uint<8>> in;
  hls::Out<hls::uint<8>> out;
  void step() { out.write(hls::uint<8>::from(in.read().to_u64() + constant())); }
};
}  // namespace errors
