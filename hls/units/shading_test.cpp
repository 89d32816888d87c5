// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/shading.h"

#include <algorithm>
#include <cmath>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using C = test::Config<8>;
using UnitBench = test::UnitBench<Shading<C>>;

constexpr std::uint32_t kUntouched = 0xdeadbeef;

class ShadingTest : public testing::Test {
 protected:
  ShadingTest() {
    frame().width = 640;
    frame().height = 480;
    frame().background = 0x00123456;
    for (auto& bank : bench_.unit.bank) {
      for (Word& word : bench_.rows(bank)) word = Word::from(kUntouched);
    }
  }
  FrameRegisters<C>& frame() { return bench_.value(bench_.unit.frame); }
  HitRecord<C>& hit(unsigned packet, unsigned ray) {
    return bench_.rows(bench_.unit.hit)[packet * 4 + ray];
  }
  std::uint64_t word(unsigned bank, std::uint64_t address) {
    return bench_.rows(bench_.unit.bank[bank])[address].to_u64();
  }
  void shade(unsigned packet, unsigned x, unsigned y) {
    bench_.rows(bench_.unit.position)[packet] = {uint<10>::from(x), uint<10>::from(y)};
    ShadeJob<C> job;
    job.packet = PacketId<C>::from(packet);
    const unsigned last = static_cast<unsigned>(kLastWrite<C>.to_u64());
    for (unsigned i = 0; i <= last; ++i) {
      EXPECT_TRUE(bench_.take(bench_.unit.free).empty());
      bench_.feed(bench_.unit.job, Repeated<ShadeJob<C>>{RepeatCount<C>::from(i), i == last, job});
      bench_.run();
    }
    EXPECT_EQ(bench_.take_one(bench_.unit.free).packet, job.packet);
  }
  std::size_t touched(unsigned bank) {
    std::size_t count = 0;
    for (const Word w : bench_.rows(bench_.unit.bank[bank])) count += w.to_u64() != kUntouched;
    return count;
  }
  UnitBench bench_;
};

std::uint64_t shaded(std::uint64_t colour, double cosine) {
  const auto brightness = static_cast<std::uint64_t>(std::min(std::abs(cosine), 1.0) * 256);
  std::uint64_t result = 0;
  for (unsigned shift = 0; shift < 24; shift += 8) {
    result |= ((colour >> shift & 255) * brightness >> 8) << shift;
  }
  return result;
}

TEST_F(ShadingTest, ColourTimesCosineAtMostOne) {
  test::Random random(7);
  std::vector<double> cosines = {1, -1, 2, -1000, 0.5, -0.5, 0x1p-8, 0x1p-9, 0x1p-30, 0.999999, 0};
  while (cosines.size() < 400) {
    cosines.push_back(std::ldexp(static_cast<double>(random.next() % 0x20000),
                                 -17 + static_cast<int>(random.next() % 2)));
  }
  for (std::size_t i = 0; i < cosines.size(); i += 4) {
    for (unsigned ray = 0; ray < kRays<C> && i + ray < cosines.size(); ++ray) {
      HitRecord<C>& h = hit(3, ray);
      h = test::random_token<HitRecord<C>>(random);
      h.hit = true;
      h.cosine = Real::from_double(cosines[i + ray]);
    }
    shade(3, 10, 20);
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      const HitRecord<C> h = hit(3, ray);
      EXPECT_EQ(word(0, (20 + ray / 2) * 640 + 10 + ray % 2),
                shaded(h.colour.to_u64(), h.cosine.to_double()))
          << h.cosine.to_double();
    }
  }
}

TEST_F(ShadingTest, AMissIsTheBackground) {
  hit(1, 2).colour = 0xffffff;
  hit(1, 2).cosine = Real::one();
  shade(1, 0, 0);
  EXPECT_EQ(word(0, 640), 0x00123456u);
}

TEST_F(ShadingTest, WithoutHitRecordsOnlyPixelsAreWritten) {
  shade(0, 100, 200);
  EXPECT_EQ(touched(0), 4u);
  EXPECT_EQ(touched(1), 0u);
  EXPECT_EQ(touched(2), 0u);
}

TEST_F(ShadingTest, HitRecordsAreSixWordsInTwoBanks) {
  test::Random random(9);
  frame().write_hits = 1;
  for (unsigned ray = 0; ray < kRays<C>; ++ray)
    hit(5, ray) = test::random_token<HitRecord<C>>(random);
  shade(5, 636, 478);
  for (unsigned ray = 0; ray < kRays<C>; ++ray) {
    const HitRecord<C> h = hit(5, ray);
    const std::uint64_t at = 3 * ((478 + ray / 2) * 640 + 636 + ray % 2);
    EXPECT_EQ(word(1, at), h.t.bits().to_u64());
    EXPECT_EQ(word(2, at), h.u.bits().to_u64());
    EXPECT_EQ(word(1, at + 1), h.v.bits().to_u64());
    EXPECT_EQ(word(2, at + 1), h.cosine.bits().to_u64());
    EXPECT_EQ(word(1, at + 2), std::uint64_t{h.hit} << 31 | h.object.to_u64());
    EXPECT_EQ(word(2, at + 2), h.triangle.to_u64());
  }
  EXPECT_EQ(touched(1), 12u);
  EXPECT_EQ(touched(2), 12u);
}

TEST_F(ShadingTest, RaysOutsideTheImageWriteNothing) {
  frame().width = 5;
  frame().height = 3;
  frame().write_hits = 1;
  shade(0, 4, 0);
  EXPECT_EQ(touched(0), 2u) << "the right column is missing";
  EXPECT_EQ(word(0, 4), 0x00123456u);
  EXPECT_EQ(word(0, 9), 0x00123456u);
  shade(0, 0, 2);
  EXPECT_EQ(touched(0), 4u) << "the lower row is missing";
  shade(0, 4, 2);
  EXPECT_EQ(touched(0), 5u) << "the corner";
  EXPECT_EQ(touched(1), 15u);
}

/// Which steps of two packets write a pixel, in their order.
template <class Of>
std::vector<bool> steps_with_pixels() {
  test::UnitBench<Shading<Of>> bench;
  bench.value(bench.unit.frame).width = 64;
  bench.value(bench.unit.frame).height = 64;
  std::vector<bool> written;
  for (unsigned packet = 0; packet < 2; ++packet) {
    bench.rows(bench.unit.position)[packet] = {uint<10>::from(4 * packet), {}};
    ShadeJob<Of> job;
    job.packet = PacketId<Of>::from(packet);
    for (RepeatCount<Of> i; i <= kLastWrite<Of>; i = hls::next(i)) {
      auto& pixels = bench.rows(bench.unit.bank[0]);
      std::ranges::fill(pixels, Word::from(kUntouched));
      bench.feed(bench.unit.job, Repeated<ShadeJob<Of>>{i, i == kLastWrite<Of>, job});
      bench.run();
      written.push_back(std::ranges::count(pixels, Word::from(kUntouched)) != std::ssize(pixels));
    }
  }
  return written;
}

template <class Of>
class ShadingOfPackets : public testing::Test {};
TYPED_TEST_SUITE(ShadingOfPackets, test::PacketSizes<C>);

TYPED_TEST(ShadingOfPackets, AClockAtLeastLiesBetweenTwoPixels) {
  const std::vector<bool> written = steps_with_pixels<TypeParam>();
  EXPECT_EQ(std::ranges::count(written, true), 2 * kRays<TypeParam>);
  for (std::size_t i = 1; i < written.size(); ++i) EXPECT_FALSE(written[i - 1] && written[i]) << i;
}

TEST_F(ShadingTest, TheFrameLiesAtItsBase) {
  frame().frame_base = 500'000;
  shade(0, 2, 4);
  EXPECT_EQ(word(0, 500'000 + 4 * 640 + 2), 0x00123456u);
  EXPECT_EQ(touched(0), 4u);
}

TEST_F(ShadingTest, TheLargestFrameFillsTheBank) {
  frame().width = 1024;
  frame().height = 1024;
  shade(0, 1022, 1022);
  EXPECT_EQ(word(0, kBankWords - 1), 0x00123456u);
  EXPECT_EQ(word(0, kBankWords - 1024 - 2), 0x00123456u);
  EXPECT_EQ(touched(0), 4u);
}

}  // namespace
}  // namespace dynrt
