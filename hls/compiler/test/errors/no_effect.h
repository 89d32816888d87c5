// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/no_effect.h: error: the unit writes no token and no row and changes no register; write an Out, or build the unit with -fsanitize=undefined to look for undefined behaviour
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  void step() { in.read(); }
};
}  // namespace errors
