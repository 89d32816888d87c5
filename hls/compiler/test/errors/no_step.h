// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
// error: errors/no_step.h: error: the unit errors::Unit has no member function void step(); a unit's step() is one transaction
#include "hls/ports.h"
namespace errors {
struct Unit {
  hls::In<hls::uint<8>> in;
};
}  // namespace errors
