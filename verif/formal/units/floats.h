// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A unit of the four operators that a float is proved by, in a format small enough for a solver.
#pragma once

#include "hls/float.h"
#include "hls/ports.h"

namespace formal {

template <hls::Rounding R>
struct Floats {
  using Real = hls::Float<3, 3, R>;
  struct Operands {
    Real a;
    Real b;
    HLS_FIELDS(a, b)
  };
  struct Results {
    Real sum;
    Real product;
    Real quotient;
    bool less;
    HLS_FIELDS(sum, product, quotient, less)
  };

  hls::In<Operands> operands;
  hls::Out<Results> results;
  HLS_PORTS(operands, results)

  void step() {
    const Operands o = operands.read();
    results.write({o.a + o.b, o.a * o.b, o.a / o.b, o.a < o.b});
  }
};

}  // namespace formal
