// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The encoder against the specification, for every byte at every disparity that a channel can have.
#include "units/tmds_encoder.h"

#include <array>
#include <bit>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

#include "units/test_bench.h"
#include "units/tmds_specification.h"

namespace dynrt {
namespace {

unsigned transitions(unsigned character) {
  return static_cast<unsigned>(std::popcount((character ^ character >> 1) & 0x1ff));
}

/// Every disparity that can occur, with bytes that lead there from the blanking.
std::map<int, std::vector<unsigned>> disparities() {
  std::map<int, std::vector<unsigned>> found = {{0, {}}};
  std::vector<int> fresh = {0};
  while (!fresh.empty()) {
    const int from = fresh.back();
    fresh.pop_back();
    for (unsigned byte = 0; byte < 256; ++byte) {
      tmds::Channel channel{from};
      channel.encode(byte);
      std::vector<unsigned> way = found.at(from);
      way.push_back(byte);
      if (found.emplace(channel.cnt, way).second) fresh.push_back(channel.cnt);
    }
  }
  return found;
}

/// Bytes whose characters tell in which disparity a channel was before them.
constexpr std::array<unsigned, 9> kTelling{};

class TmdsEncoderTest : public testing::Test {
 protected:
  /// A visible pixel of these bytes; the reference's characters of it are expected.
  void visible(std::array<unsigned, 3> bytes) {
    const unsigned colour = bytes[0] << 16 | bytes[1] << 8 | bytes[2];
    pixels_.push_back({uint<24>::from(colour), false, false, true});
    std::array<unsigned, 3> characters{};
    for (unsigned c = 0; c < 3; ++c) characters[c] = specified_[c].encode(bytes[c]);
    expect(characters);
  }
  void blank(bool hsync, bool vsync) {
    pixels_.push_back({uint<24>(0x5a5a5a), hsync, vsync, false});
    specified_ = {};
    expect({tmds::kControl[(vsync ? 2u : 0u) + (hsync ? 1u : 0u)], tmds::kControl[0],
            tmds::kControl[0]});
  }
  void compare() {
    for (const ScanPixel& pixel : pixels_) bench_.feed(bench_.unit.pixel, pixel);
    bench_.run();
    EXPECT_TRUE(test::same(bench_.take(bench_.unit.characters), expected_));
    pixels_.clear();
    expected_.clear();
  }

 private:
  void expect(const std::array<unsigned, 3>& c) {
    expected_.push_back(
        {TmdsCharacter::from(c[0]), TmdsCharacter::from(c[1]), TmdsCharacter::from(c[2])});
  }
  test::UnitBench<TmdsEncoder> bench_;
  std::array<tmds::Channel, 3> specified_;
  std::vector<ScanPixel> pixels_;
  std::vector<TmdsPixel> expected_;
};

TEST_F(TmdsEncoderTest, EncodesEveryByteAtEveryDisparityAsSpecified) {
  const auto ways = disparities();
  EXPECT_EQ(ways.size(), 9u);  // -8 to 8, always even
  for (unsigned channel = 0; channel < 3; ++channel) {
    for (const auto& [disparity, way] : ways) {
      for (unsigned byte = 0; byte < 256; ++byte) {
        const auto on_channel = [channel](unsigned value) {
          std::array<unsigned, 3> bytes = {value ^ 0x0f, value ^ 0x71, value ^ 0xe2};
          bytes[channel] = value;
          return bytes;
        };
        blank(byte % 2 != 0, byte / 2 % 2 != 0);
        for (const unsigned on_the_way : way) visible(on_channel(on_the_way));
        visible(on_channel(byte));
        for (const unsigned telling : kTelling) visible({telling, telling, telling});
      }
    }
    compare();
  }
}

TEST_F(TmdsEncoderTest, EncodesEachPairOfSyncsAsSpecified) {
  for (unsigned syncs = 0; syncs < 16; ++syncs) {
    blank((syncs & 1) != 0, (syncs & 2) != 0);
    blank((syncs & 4) != 0, (syncs & 8) != 0);
  }
  compare();
}

TEST_F(TmdsEncoderTest, ForgetsTheDisparityInTheBlanking) {
  visible({0x00, 0x00, 0x00});
  visible({0x10, 0xff, 0x55});
  blank(true, false);
  visible({0x00, 0x01, 0xff});
  compare();
}

TEST(TmdsSpecification, TellsDisparitiesApart) {
  std::set<std::vector<unsigned>> told;
  for (const auto& [disparity, way] : disparities()) {
    tmds::Channel channel{disparity};
    std::vector<unsigned> characters;
    for (const unsigned byte : kTelling) characters.push_back(channel.encode(byte));
    EXPECT_TRUE(told.insert(characters).second) << disparity;
  }
}

TEST(TmdsSpecification, DecodesToTheByteWithFewTransitions) {
  for (const auto& [disparity, way] : disparities()) {
    EXPECT_EQ(disparity % 2, 0);
    EXPECT_LE(std::abs(disparity), 8);
    for (unsigned byte = 0; byte < 256; ++byte) {
      tmds::Channel channel{disparity};
      const unsigned character = channel.encode(byte);
      ASSERT_EQ(tmds::decode(character), byte);
      ASSERT_LE(transitions(character), 5u) << byte;
      ASSERT_EQ(channel.cnt - disparity, 2 * std::popcount(character) - 10) << byte;
    }
  }
}

}  // namespace
}  // namespace dynrt
