// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/no_effect.h: error: the unit writes no token and no row and changes no register; write an Out, or look for undefined behaviour with a build under -fsanitize=undefined
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
  void step() { in.read(); }
};
}  // namespace errors
