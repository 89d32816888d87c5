// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Test unit: what LLVM has intrinsics for: saturation, rotation, bit counts, overflow, minima,
// three-way comparison.
#pragma once

#include <algorithm>

#include "hls/ports.h"

namespace samples {

using hls::uint;

struct Words {
  uint<32> a;
  uint<32> b;
  uint<19> c;
  HLS_FIELDS(a, b, c)
};
struct Answers {
  std::array<uint<32>, 18> words;
  HLS_FIELDS(words)
};

struct Intrinsics {
  hls::In<Words> words;
  hls::Out<Answers> answers;
  HLS_PORTS(words, answers)

  static unsigned overflow(unsigned a, unsigned b) {
    unsigned sum = 0;
    unsigned product = 0;
    int difference = 0;
    const bool too_large = __builtin_add_overflow(a, b, &sum);
    const bool far_too_large = __builtin_mul_overflow(a, b, &product);
    const bool off = __builtin_sub_overflow(static_cast<int>(a), static_cast<int>(b), &difference);
    return sum ^ product ^ static_cast<unsigned>(difference) ^ (too_large ? 1u : 0u) ^
           (far_too_large ? 2u : 0u) ^ (off ? 4u : 0u);
  }

  static unsigned three_way(unsigned a, unsigned b) { return a < b ? ~0u : a > b ? 1u : 0u; }

  void step() {
    const Words w = words.read();
    const auto a = static_cast<unsigned>(w.a.to_u64());
    const auto b = static_cast<unsigned>(w.b.to_u64());
    const auto c = static_cast<unsigned>(w.c.to_u64());
    const auto sa = static_cast<int>(a);
    const auto sb = static_cast<int>(b);
    const auto c19 = w.c.raw();
    const unsigned results[18] = {
        __builtin_elementwise_add_sat(a, b),
        __builtin_elementwise_sub_sat(a, b),
        static_cast<unsigned>(__builtin_elementwise_add_sat(sa, sb)),
        static_cast<unsigned>(__builtin_elementwise_sub_sat(sa, sb)),
        __builtin_rotateleft32(a, b),
        __builtin_rotateright32(a, c),
        __builtin_bitreverse32(a),
        __builtin_bswap32(b),
        static_cast<unsigned>(__builtin_popcountg(c19)),
        static_cast<unsigned>(__builtin_ctzg(c19, 19)),
        static_cast<unsigned>(__builtin_clzg(c19, 19)),
        std::min(a, b) + std::max(c, b),
        static_cast<unsigned>(std::min(sa, sb)) ^ static_cast<unsigned>(std::max(sa, 7)),
        overflow(a, b),
        three_way(a, b),
        static_cast<unsigned>(__builtin_elementwise_abs(sa / 2)),
        a % 8 + b % (c | 1),
        static_cast<unsigned>(sa >> (b % 32)) + (a << (c % 32)),
    };
    Answers out;
    for (unsigned i = 0; i < 18; ++i) out.words[i] = uint<32>::from(results[i]);
    answers.write(out);
  }
};

}  // namespace samples
