// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: the operators of Float<7, 16>, and of a small format that truncates.
#pragma once

#include "hls/float.h"
#include "hls/ports.h"

namespace samples {

using Real = hls::Float<7, 16>;
using Small = hls::Float<4, 3, hls::Rounding::kTruncate>;

struct FloatPair {
  Real a;
  Real b;
  Small c;
  Small d;
  HLS_FIELDS(a, b, c, d)
};
struct FloatResults {
  Real sum;
  Real difference;
  Real product;
  Real quotient;
  Real root;
  Small small_sum;
  Small small_product;
  Small small_quotient;
  Small small_root;
  bool less;
  HLS_FIELDS(sum, difference, product, quotient, root, small_sum, small_product, small_quotient,
             small_root, less)
};

struct Floats {
  hls::In<FloatPair> pair;
  hls::Out<FloatResults> results;
  HLS_PORTS(pair, results)

  void step() {
    const FloatPair p = pair.read();
    results.write({p.a + p.b, p.a - p.b, p.a * p.b, p.a / p.b, sqrt(p.a), p.c + p.d, p.c * p.d,
                   p.c / p.d, sqrt(p.c), p.a < p.b});
  }
};

}  // namespace samples
