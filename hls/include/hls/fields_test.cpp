// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens: widths, the place of every leaf, and every kind of leaf there and back.
#include "hls/fields.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "hls/float.h"

namespace {

enum class Colour : unsigned char { kRed, kGreen, kBlue };

struct Inner {
  hls::uint<3> low;
  hls::sint<5> high;
  HLS_FIELDS(low, high)
};
struct Token {
  bool flag = false;
  Colour colour = Colour::kRed;
  std::array<Inner, 2> inner;
  hls::Float<3, 4> real;
  hls::uint<64> wide;
  HLS_FIELDS(flag, colour, inner, real, wide)
};

}  // namespace

template <>
inline constexpr unsigned hls::enum_width<Colour> = 2;

namespace {

static_assert(hls::bit_width_of<bool>() == 1);
static_assert(hls::bit_width_of<Colour>() == 2);
static_assert(hls::bit_width_of<Inner>() == 8);
static_assert(hls::bit_width_of<hls::Float<7, 16>>() == 24);
static_assert(hls::bit_width_of<std::array<Inner, 3>>() == 24);
static_assert(hls::bit_width_of<Token>() == 1 + 2 + 16 + 8 + 64);
static_assert(Token::hls_field_names() == "flag, colour, inner, real, wide");

TEST(Fields, EveryLeafIsCopied) {
  Token from;
  hls::for_each_leaf(from, []<class L>(L& leaf, unsigned offset) {
    leaf = hls::leaf_from_bits<L>(hls::uint<hls::bit_width_of<L>()>::from(offset + 1));
  });
  Token to;
  hls::copy_leaves(to, from);
  std::vector<std::uint64_t> expected, got;
  hls::for_each_leaf(from, [&](const auto& leaf, unsigned) {
    expected.push_back(hls::leaf_to_bits(leaf).to_u64());
  });
  hls::for_each_leaf(
      to, [&](const auto& leaf, unsigned) { got.push_back(hls::leaf_to_bits(leaf).to_u64()); });
  EXPECT_EQ(got, expected);
  EXPECT_EQ(got.size(), 8u);
}

TEST(Fields, LeavesLieInOrderFromTheLowestBit) {
  std::vector<std::pair<unsigned, unsigned>> places;
  const Token token;
  hls::for_each_leaf(token, [&]<class L>(const L&, unsigned offset) {
    places.emplace_back(offset, hls::bit_width_of<L>());
  });
  const std::vector<std::pair<unsigned, unsigned>> expected = {{0, 1},  {1, 2},  {3, 3},  {6, 5},
                                                               {11, 3}, {14, 5}, {19, 8}, {27, 64}};
  EXPECT_EQ(places, expected);
}

template <class L>
void round_trip(std::uint64_t count) {
  using Bits = hls::uint<hls::bit_width_of<L>()>;
  for (std::uint64_t bits = 0; bits < count; ++bits) {
    const L leaf = hls::leaf_from_bits<L>(Bits::from(bits));
    EXPECT_EQ(hls::leaf_to_bits(leaf).to_u64(), bits);
  }
}
TEST(Fields, EveryKindOfLeafKeepsItsBits) {
  round_trip<bool>(2);
  round_trip<Colour>(3);
  round_trip<hls::uint<6>>(64);
  round_trip<hls::sint<6>>(64);
  round_trip<hls::Float<3, 4>>(256);
}
TEST(Fields, BitsAreTheLeafsOwn) {
  EXPECT_EQ(hls::leaf_to_bits(hls::sint<6>(-1)).to_u64(), 63u);
  EXPECT_EQ(hls::leaf_to_bits(Colour::kBlue).to_u64(), 2u);
  EXPECT_TRUE(hls::leaf_from_bits<bool>(hls::uint<1>(1)));
  EXPECT_EQ(hls::leaf_from_bits<hls::sint<6>>(hls::uint<6>(32)).to_s64(), -32);
  EXPECT_EQ((hls::leaf_to_bits(hls::Float<3, 4>::one()).to_u64()), 3u << 4);
}
/// With and without a field.
template <bool Present>
struct Optional {
  hls::uint<3> first;
  hls::OptionalField<Present, hls::uint<5>> maybe;
  hls::uint<2> last;
  HLS_FIELDS(first, maybe, last)
};
static_assert(hls::bit_width_of<Optional<true>>() == 10);
static_assert(hls::bit_width_of<Optional<false>>() == 5);
TEST(Fields, AnAbsentFieldTakesNoBitsAndDropsWhatIsWritten) {
  const Optional<true> with{1, hls::uint<5>(17), 2};
  const Optional<false> without{1, hls::uint<5>(17), 2};
  EXPECT_EQ(with.maybe.get().to_u64(), 17u);
  EXPECT_EQ(without.maybe.get().to_u64(), 0u);
  std::vector<unsigned> offsets;
  hls::for_each_leaf(without, [&](const auto&, unsigned offset) { offsets.push_back(offset); });
  EXPECT_EQ(offsets, (std::vector<unsigned>{0, 3}));
}

struct InWords {
  hls::uint<32> all;
  hls::uint<17> low;
  hls::uint<14> between;
  bool top = false;
  HLS_FIELDS(all, low, between, top)
};
TEST(Fields, WordsHoldTheLeavesFromTheLowestBitOn) {
  constexpr InWords kToken{hls::uint<32>::from(0xfedcba98u), 0x1abcd, 0, true};
  static_assert(hls::word_of<0>(kToken) == hls::uint<32>::from(0xfedcba98u));
  EXPECT_EQ(hls::word_of<1>(kToken).to_u64(), 0x8001abcdu);
  EXPECT_EQ(hls::word_of<2>(kToken).to_u64(), 0u);
}

TEST(Fields, LeavesCanBeWritten) {
  Token token;
  unsigned leaves = 0;
  hls::for_each_leaf(token, [&]<class L>(L& leaf, unsigned) {
    leaf = hls::leaf_from_bits<L>(hls::uint<hls::bit_width_of<L>()>::from(1));
    ++leaves;
  });
  EXPECT_EQ(leaves, 8u);
  EXPECT_TRUE(token.flag);
  EXPECT_EQ(token.colour, Colour::kGreen);
  EXPECT_EQ(token.inner[1].high.to_s64(), 1);
  EXPECT_EQ(token.real.bits().to_u64(), 1u);
  EXPECT_EQ(token.wide.to_u64(), 1u);
}

}  // namespace
