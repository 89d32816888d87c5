// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Random numbers and random tokens for tests: the same stream for the same seed everywhere.
#pragma once

#include <cstdint>

#include "hls/fields.h"

namespace hls::testing {

/// splitmix64: a stream of 64-bit numbers from a seed (G. Steele, D. Lea, C. Flood, "Fast
/// Splittable Pseudorandom Number Generators", OOPSLA 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t below(std::uint64_t limit) { return next() % limit; }
  bool chance(double probability) {
    return static_cast<double>(next() >> 11) * 0x1p-53 < probability;
  }

 private:
  std::uint64_t state_;
};

/// Bits of a leaf: any, small, all zeros, all ones; Floats also about one and at their ends.
template <class L>
L random_leaf(Random& random) {
  constexpr unsigned kWidth = bit_width_of<L>();
  std::uint64_t bits = random.next();
  if constexpr (requires { L::kBias; }) {
    constexpr std::uint64_t kField = (std::uint64_t{1} << L::kExponentBits) - 1;
    const std::uint64_t keep = bits & ~(kField << L::kMantissaBits);
    const auto bias = static_cast<std::uint64_t>(L::kBias);
    switch (random.below(8)) {
      case 0:
        bits = keep | (random.below(2) ? kField : 0) << L::kMantissaBits;
        break;
      case 1:
        bits = random.below(4) == 0 ? L::largest().bits().to_u64() : 0;
        bits |= (random.next() & 1) << (kWidth - 1);
        break;
      case 2:
        break;
      default:  // so near that sums round and cancel
        bits = keep | ((bias + random.below(15) - 7) & kField) << L::kMantissaBits;
        break;
    }
  } else if constexpr (kWidth > 2) {
    switch (random.below(8)) {
      case 0:
        bits = 0;
        break;
      case 1:
        bits = ~std::uint64_t{0};
        break;
      case 2:
      case 3:
        bits >>= 64 - kWidth + random.below(kWidth);
        break;
      default:
        break;
    }
  }
  return leaf_from_bits<L>(uint<kWidth>::from(bits));
}

/// Draws new leaves for a token, but keeps each with a chance of one in eight, as mailboxes, caches
/// and comparisons need equal values in consecutive tokens.
template <class T>
void randomise(T& token, Random& random) {
  for_each_leaf(token, [&random]<class L>(L& leaf, unsigned) {
    if (random.below(8) != 0) leaf = random_leaf<L>(random);
  });
}

}  // namespace hls::testing
