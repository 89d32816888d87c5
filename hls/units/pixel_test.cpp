// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Pixels of 16 bits: every one of them, and every value of a channel.
#include "units/pixel.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

namespace dynrt {
namespace {

using hls::uint;

constexpr unsigned kPixels = 1u << 16;

unsigned colour_of(unsigned pixel) {
  return static_cast<unsigned>(HalfPixel::colour(uint<16>::from(pixel)).to_u64());
}
unsigned pixel_of(unsigned colour) {
  return static_cast<unsigned>(HalfPixel::of(uint<32>::from(colour)).to_u64());
}
/// The nearest of 0 to 255 to a channel that has so many bits.
unsigned stretched(unsigned channel, unsigned bits) {
  const unsigned most = (1u << bits) - 1;
  return (2 * 255 * channel + most) / (2 * most);
}

TEST(HalfPixel, HasTheColourThatIsStretchedOverTheRange) {
  for (unsigned pixel = 0; pixel < kPixels; ++pixel) {
    const unsigned expected[] = {stretched(pixel & 31, 5), stretched(pixel >> 5 & 63, 6),
                                 stretched(pixel >> 11, 5)};
    const unsigned colour = colour_of(pixel);
    ASSERT_EQ(colour >> 24, 0u);
    for (unsigned channel = 0; channel < 3; ++channel) {
      const int difference =
          static_cast<int>(colour >> (8 * channel) & 255) - static_cast<int>(expected[channel]);
      ASSERT_LE(std::abs(difference), 1) << pixel;
    }
  }
}

TEST(HalfPixel, IsThatOfItsColour) {
  for (unsigned pixel = 0; pixel < kPixels; ++pixel) ASSERT_EQ(pixel_of(colour_of(pixel)), pixel);
}

/// No channel is further off than its step, and none is brighter or darker on the whole.
TEST(HalfPixel, HasEachChannelOfAColour) {
  for (unsigned channel = 0; channel < 3; ++channel) {
    const unsigned step = channel == 1 ? 4 : 8;
    int sum = 0;
    for (unsigned value = 0; value < 256; ++value) {
      const unsigned colour = value << (8 * channel);
      const unsigned seen = colour_of(pixel_of(colour));
      ASSERT_EQ(seen & ~(255u << (8 * channel)), 0u);
      const int difference = static_cast<int>(seen >> (8 * channel)) - static_cast<int>(value);
      ASSERT_LT(std::abs(difference), static_cast<int>(step));
      sum += difference;
    }
    EXPECT_EQ(sum, 0);
  }
}

TEST(HalfPixel, HasTheEndsOfTheRange) {
  EXPECT_EQ(HalfPixel::colour(0x0000), uint<24>(0));
  EXPECT_EQ(HalfPixel::colour(0xffff), uint<24>(0xffffff));
  EXPECT_EQ(HalfPixel::colour(0x001f), uint<24>(0x0000ff));  // red
  EXPECT_EQ(HalfPixel::colour(0x07e0), uint<24>(0x00ff00));
  EXPECT_EQ(HalfPixel::colour(0xf800), uint<24>(0xff0000));  // blue
  EXPECT_EQ(HalfPixel::colour(0x0410), uint<24>(0x008284));
}

TEST(WordPixel, IsTheColour) {
  EXPECT_EQ(WordPixel::of(0x123456), uint<32>(0x123456));
  EXPECT_EQ(WordPixel::colour(0x123456), uint<24>(0x123456));
}

}  // namespace
}  // namespace dynrt
