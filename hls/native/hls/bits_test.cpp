// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/bits.h"

#include <gtest/gtest.h>

#include "hls/float.h"

namespace {

using Real = hls::Float<7, 16>;

struct Point {
  Real x, y;
  HLS_FIELDS(x, y)
};
struct Token {
  hls::uint<6> packet;
  bool last = false;
  std::array<Point, 2> ray;
  hls::sint<5> step;
  hls::uint<64> stamp;
  HLS_FIELDS(packet, last,  //
             ray, step, stamp)
};
static_assert(hls::words_of<Token> == 6);  // 6 + 1 + 96 + 5 + 64 = 172 bits

Token example() {
  Token token;
  token.packet = 37;
  token.last = true;
  token.ray[0].x = Real::from_double(1.5);
  token.ray[1].y = Real::from_double(-0.1);
  token.step = -3;
  token.stamp = hls::uint<64>::from(0x8123456789abcdef);
  return token;
}

TEST(Bits, WordsHoldTheLeavesFromTheLowestBit) {
  const auto words = hls::pack(example());
  EXPECT_EQ(words[0] & 0x3f, 37u);
  EXPECT_EQ((words[0] >> 6) & 1, 1u);
  EXPECT_EQ((words[0] >> 7) & 0xffffff, example().ray[0].x.bits().to_u64());
  EXPECT_EQ(hls::get_bits(words.data(), 103, 5), 29u);
  EXPECT_EQ(hls::get_bits(words.data(), 108, 64), 0x8123456789abcdefu);
  EXPECT_EQ(words[5] >> (172 - 160), 0u) << "bits beyond the token are zero";
}

TEST(Bits, UnpackUndoesPack) {
  const auto words = hls::pack(example());
  const Token back = hls::unpack<Token>(words);
  EXPECT_EQ(hls::pack(back), words);
  EXPECT_EQ(back.packet.to_u64(), 37u);
  EXPECT_TRUE(back.last);
  EXPECT_EQ(back.ray[0].x, Real::from_double(1.5));
  EXPECT_EQ(back.ray[1].y, Real::from_double(-0.1));
  EXPECT_EQ(back.step.to_s64(), -3);
  EXPECT_EQ(back.stamp.to_u64(), 0x8123456789abcdefu);
}

TEST(Bits, EveryOffsetAndWidthComesBack) {
  for (unsigned offset = 0; offset < 64; ++offset) {
    for (unsigned width = 1; width <= 64; ++width) {
      std::uint32_t words[4] = {};
      const std::uint64_t bits = 0xa5c3'96f0'1e2d'7b89u >> (64 - width);
      hls::put_bits(words, offset, width, bits);
      ASSERT_EQ(hls::get_bits(words, offset, width), bits) << offset << ' ' << width;
      ASSERT_EQ(offset == 0 ? 0 : hls::get_bits(words, 0, offset), 0u);
      ASSERT_EQ(hls::get_bits(words, offset + width, 1), 0u);
    }
  }
}

TEST(Bits, DescribeNamesEveryLeaf) {
  Token token = example();
  token.ray[1].y = Real::one();
  EXPECT_EQ(hls::describe(token),
            "packet = 37 (0x25), last = true, ray[0].x = 1.5 (0x3f8000), "
            "ray[0].y = 1.08420217e-19 (0x000000), ray[1].x = 1.08420217e-19 (0x000000), "
            "ray[1].y = 1 (0x3f0000), step = -3 (0x1d), "
            "stamp = 9305357566071262703 (0x8123456789abcdef)");
  EXPECT_EQ(hls::describe(hls::uint<4>(9)), "9 (0x9)");
}

TEST(Bits, DifferencesNameTheFieldAndBothValues) {
  const Token left = example();
  EXPECT_FALSE(hls::first_difference(left, left).has_value());
  Token right = left;
  right.step = 2;
  right.stamp = 0;
  EXPECT_EQ(hls::first_difference(left, right)->text(), "step: -3 (0x1d) against 2 (0x2)");
  right.ray[1].x = Real::one();
  EXPECT_EQ(hls::first_difference(left, right)->text(),
            "ray[1].x: 1.08420217e-19 (0x000000) against 1 (0x3f0000)");
  EXPECT_EQ(hls::first_difference(false, true)->text(), "value: false against true");
}

}  // namespace
