// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The encoder against the algorithm as the specification draws it (Digital Visual Interface 1.0,
// figure 3-5), for every byte at every disparity that a channel can have.
#include "units/tmds_encoder.h"

#include <array>
#include <bit>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

#include "units/test_bench.h"

namespace dynrt {
namespace {

/// Figure 3-5, in its names; bit i of the result is q_out[i].
struct Specified {
  int cnt = 0;

  unsigned encode(unsigned d) {
    const int n1_of_d = std::popcount(d);
    std::array<int, 9> q_m{};
    const bool xnor = n1_of_d > 4 || (n1_of_d == 4 && (d & 1) == 0);
    q_m[0] = static_cast<int>(d & 1);
    for (unsigned i = 1; i < 8; ++i) {
      const int differs = q_m[i - 1] ^ static_cast<int>(d >> i & 1);
      q_m[i] = xnor ? 1 - differs : differs;
    }
    q_m[8] = xnor ? 0 : 1;
    int n1 = 0;
    for (unsigned i = 0; i < 8; ++i) n1 += q_m[i];
    const int n0 = 8 - n1;

    std::array<int, 10> q_out{};
    q_out[8] = q_m[8];
    if (cnt == 0 || n1 == n0) {
      q_out[9] = 1 - q_m[8];
      cnt += q_m[8] == 0 ? n0 - n1 : n1 - n0;
    } else if ((cnt > 0 && n1 > n0) || (cnt < 0 && n0 > n1)) {
      q_out[9] = 1;
      cnt += 2 * q_m[8] + (n0 - n1);
    } else {
      q_out[9] = 0;
      cnt += -2 * (1 - q_m[8]) + (n1 - n0);
    }
    unsigned character = 0;
    for (unsigned i = 0; i < 8; ++i) q_out[i] = q_out[9] != 0 ? 1 - q_m[i] : q_m[i];
    for (unsigned i = 0; i < 10; ++i) character |= static_cast<unsigned>(q_out[i]) << i;
    return character;
  }
};

/// Figure 3-6.
unsigned decode(unsigned character) {
  const unsigned d = (character >> 9 & 1) != 0 ? ~character & 0xff : character & 0xff;
  unsigned q = d & 1;
  for (unsigned i = 1; i < 8; ++i) {
    const unsigned differs = (d >> i ^ d >> (i - 1)) & 1;
    q |= ((character >> 8 & 1) != 0 ? differs : 1 - differs) << i;
  }
  return q;
}

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
      Specified channel{from};
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
    static constexpr unsigned kControl[] = {0b1101010100, 0b0010101011, 0b0101010100, 0b1010101011};
    pixels_.push_back({uint<24>(0x5a5a5a), hsync, vsync, false});
    specified_ = {};
    expect({kControl[(vsync ? 2u : 0u) + (hsync ? 1u : 0u)], kControl[0], kControl[0]});
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
  std::array<Specified, 3> specified_;
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
    Specified channel{disparity};
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
      Specified channel{disparity};
      const unsigned character = channel.encode(byte);
      ASSERT_EQ(decode(character), byte);
      ASSERT_LE(transitions(character), 5u) << byte;
      ASSERT_EQ(channel.cnt - disparity, 2 * std::popcount(character) - 10) << byte;
    }
  }
}

}  // namespace
}  // namespace dynrt
