// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "host/format/memory_format_of.h"

namespace dynrt::host {
namespace {

template <class R>
class Formats : public testing::Test {
 protected:
  static constexpr const MemoryFormat& kFormat = kMemoryFormatOf<R>;
  std::mt19937_64 random_{7};

  double number() {
    return kFormat.number(static_cast<std::uint32_t>(random_() & ((1ull << R::kLeafWidth) - 1)));
  }
};

using Floats = testing::Types<hls::Float<5, 8>, hls::Float<6, 12>, hls::Float<7, 16>,
                              hls::Float<7, 16, hls::Rounding::kTruncate>, hls::Float<8, 16>,
                              hls::Float<7, 20>, hls::Float<8, 23>,
                              hls::Float<8, 23, hls::Rounding::kTruncate>>;
TYPED_TEST_SUITE(Formats, Floats);

TYPED_TEST(Formats, SayWhatTheFloatIs) {
  const MemoryFormat& format = this->kFormat;
  const int bias = (1 << (TypeParam::kExponentBits - 1)) - 1;
  EXPECT_EQ(format.exponent_bits, TypeParam::kExponentBits);
  EXPECT_EQ(format.mantissa_bits, TypeParam::kMantissaBits);
  EXPECT_EQ(format.rounding, TypeParam::kRounding);
  EXPECT_EQ(format.smallest, std::ldexp(1.0, -bias));
  EXPECT_EQ(format.largest,
            std::ldexp(2.0 - std::ldexp(1.0, -static_cast<int>(format.mantissa_bits)), bias + 1));
  EXPECT_GE(format.word_bits, 32u);
  EXPECT_LE(format.bus_words(), 2u);
  EXPECT_EQ(format.word_bits == 32, TypeParam::kLeafWidth <= 24);
}

TYPED_TEST(Formats, RoundAsTheCoreDoes) {
  const MemoryFormat& format = this->kFormat;
  std::uniform_real_distribution<double> mantissa(1, 2);
  std::uniform_int_distribution<int> exponent(-140, 140);
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::ldexp(mantissa(this->random_), exponent(this->random_));
    const double rounded = format.round(x);
    ASSERT_EQ(format.round(rounded), rounded);
    ASSERT_EQ(format.round(-x), -rounded);
    ASSERT_EQ(format.holds(x), x <= format.largest);
    if (x > format.largest) {
      ASSERT_EQ(rounded, format.largest);
    } else if (x < format.smallest) {
      ASSERT_EQ(rounded, format.smallest);
    } else {
      const double step = std::ldexp(1.0, std::ilogb(x) - static_cast<int>(format.mantissa_bits));
      if (format.rounding == hls::Rounding::kTruncate) {
        ASSERT_TRUE(rounded <= x && x - rounded < step) << x;
      } else {
        ASSERT_LE(std::abs(rounded - x), x > format.largest - step ? step : step / 2) << x;
      }
    }
  }
  EXPECT_EQ(format.round(0), format.smallest);
}

TYPED_TEST(Formats, GetBackWhatTheyPack) {
  const MemoryFormat& format = this->kFormat;
  const std::uint64_t beyond = ~std::uint64_t{0} << (format.word_bits - 1) << 1;
  for (int i = 0; i < 10'000; ++i) {
    const MemoryNode node{static_cast<NodeKind>(this->random_() % 4), this->number(),
                          static_cast<std::uint32_t>(this->random_() % kMaxNodes),
                          static_cast<std::uint32_t>(this->random_() % kMaxNodes)};
    const auto words = format.pack_node(node);
    for (const MemoryWord word : words) ASSERT_EQ(word & beyond, 0u);
    const MemoryNode back = format.unpack_node(words);
    ASSERT_EQ(back.kind, node.kind);
    ASSERT_EQ(back.split, node.split);
    ASSERT_EQ(back.left, node.left);
    ASSERT_EQ(back.right, node.right);

    // The spare bits of a column hold 24 bits or a float, whichever is more.
    const unsigned spare = std::max(24u, TypeParam::kLeafWidth);
    const MemoryColumn column{{this->number(), this->number(), this->number()},
                              this->random_() & ((std::uint64_t{1} << spare) - 1)};
    const auto rows = format.pack_column(column);
    for (const MemoryWord word : rows) ASSERT_EQ(word & beyond, 0u);
    const MemoryColumn again = format.unpack_column(rows);
    ASSERT_EQ(again.value, column.value);
    ASSERT_EQ(again.spare, column.spare);
  }
}

/// The bounds that units/world_box.h reads.
template <class R>
WorldBoxSlabs<R> slabs_in(const MemoryFormat& format, const MemoryColumn& column) {
  MatrixColumn<R> words;
  const auto rows = format.pack_column(column);
  for (unsigned r = 0; r < 3; ++r) {
    using Bits = uint<hls::bit_width_of<MatrixWord<R>>()>;
    words.row[r] = hls::from_bits<MatrixWord<R>>(Bits::from(rows[r]));
  }
  return slabs_of(words);
}

TYPED_TEST(Formats, RoundBoxesOutwards) {
  const MemoryFormat& format = this->kFormat;
  using B = Bound<TypeParam>;
  const auto check = [&](double low, double high) {
    const auto slab = slabs_in<TypeParam>(format, format.box_column({low, -1, 1}, {high, 1, 2}))[0];
    ASSERT_LE(slab.low.to_double(), low);
    ASSERT_GE(slab.high.to_double(), high);
    // To the next number, of which none lies between the smallest ones.
    const double least = 2 * B::smallest().to_double();
    const double step = std::ldexp(1.0, -static_cast<int>(B::kMantissaBits));
    ASSERT_GE(slab.low.to_double(), low - std::max(step * std::abs(low), least)) << low;
    ASSERT_LE(slab.high.to_double(), high + std::max(step * std::abs(high), least)) << high;
  };
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::uniform_int_distribution<int> exponent(-18, 13);
  for (int i = 0; i < 10'000; ++i) {
    const double low = std::ldexp(mantissa(this->random_), exponent(this->random_));
    check(low, low + std::abs(std::ldexp(mantissa(this->random_), exponent(this->random_))));
  }
  check(0, 0);
  check(-1, 1);
  check(std::ldexp(-1.0, -300), std::ldexp(1.0, -300));
  check(std::ldexp(1.0, -300), 2);
  check(-2, std::ldexp(-1.0, -300));
  const auto slabs = slabs_in<TypeParam>(format, format.box_column({1, -2, 0.5}, {3, -1, 4}));
  for (const auto& [slab, low, high] :
       {std::tuple(slabs[0], 1.0, 3.0), {slabs[1], -2.0, -1.0}, {slabs[2], 0.5, 4.0}}) {
    EXPECT_EQ(slab.low.to_double(), low) << "axis by axis, and exact where they can be";
    EXPECT_EQ(slab.high.to_double(), high);
  }
}

/// By hand: what a board with 32-bit words has held since there is one.
TEST(ShippedFormat, HasItsBitsInTheirPlaces) {
  const MemoryFormat& format = kShippedFormat;
  const std::uint32_t minus_2_5 = 1u << 23 | 64u << 16 | 1u << 14;
  EXPECT_EQ(format.bits(-2.5), minus_2_5);
  const auto node = format.pack_node({NodeKind::kSplitZ, -2.5, 345678, 98765});
  const std::uint64_t all = std::uint64_t{2} | std::uint64_t{minus_2_5} << 2 |
                            std::uint64_t{345678} << 26 | std::uint64_t{98765} << 45;
  EXPECT_EQ(node[0], all & 0xffffffff);
  EXPECT_EQ(node[1], all >> 32);
  const auto column = format.pack_column({{-2.5, 1, 2}, 0xabcdef});
  EXPECT_EQ(column[0], minus_2_5 | 0xefull << 24);
  EXPECT_EQ(column[1], (63u << 16) | 0xcdull << 24);
  EXPECT_EQ(column[2], (64u << 16) | 0xabull << 24);
}

}  // namespace
}  // namespace dynrt::host
