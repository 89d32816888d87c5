// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/ray_generation.h"

#include <algorithm>
#include <deque>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using Four = test::Config<64>;

struct Image {
  unsigned width, height;
  bool scanline;
  unsigned packets;
};

template <class C>
struct Packet {
  unsigned x, y;
  RayMask<C> active;
};

template <class C>
std::size_t packets_of(const Image& image) {
  const unsigned columns = packet_columns(kRays<C>), rows = packet_rows(kRays<C>);
  return std::size_t{(image.width + columns - 1) / columns} * ((image.height + rows - 1) / rows);
}

template <class C>
class Generator {
 public:
  explicit Generator(const Image& image) {
    FrameRegisters<C>& frame = bench_.value(bench_.unit.frame);
    frame.packets = Word::from(image.packets);
    frame.width = Word::from(image.width);
    frame.height = Word::from(image.height);
    frame.scanline = Word::from(image.scanline);
    frame.morton_bits = Word::from(morton_bits(image.width, image.height, kRays<C>));
    frame.camera_matrix = 77;
    for (unsigned p = 0; p < image.packets; ++p) give_back(PacketId<C>::from(p));
  }
  void give_back(PacketId<C> packet) { bench_.feed(bench_.unit.free, FreePacket<C>{packet}); }
  /// Lets the unit work; returns the packets that are now under way.
  std::vector<TransformJob<C>> run() {
    bench_.run();
    for (;;) {
      const auto skipped = bench_.take(bench_.unit.skipped);
      if (skipped.empty()) break;
      skipped_ += skipped.size();
      for (const FreePacket<C>& free : skipped) give_back(free.packet);
      bench_.run();
    }
    dones_ += bench_.take(bench_.unit.done).size();
    return bench_.take(bench_.unit.job);
  }
  Packet<C> packet_of(const TransformJob<C>& job) {
    const PixelPosition p = bench_.rows(bench_.unit.position)[job.packet.to_u64()];
    return {static_cast<unsigned>(p.x.to_u64()), static_cast<unsigned>(p.y.to_u64()), job.active};
  }
  std::size_t dones() const { return dones_; }
  std::size_t skipped() const { return skipped_; }

 private:
  test::UnitBench<RayGeneration<C>> bench_;
  std::size_t dones_ = 0;
  std::size_t skipped_ = 0;
};

template <class C>
struct Made {
  std::vector<Packet<C>> packets;  ///< in the order in which they are made
  std::size_t skipped = 0;
};

/// A frame; its packets come back in random order.
template <class C>
Made<C> frame(const Image& image) {
  Generator<C> generator(image);
  test::Random random(image.width * 4099 + image.height);
  std::vector<Packet<C>> packets;
  std::vector<TransformJob<C>> under_way;
  while (packets.size() <= packets_of<C>(image)) {
    for (const auto& job : generator.run()) {
      EXPECT_EQ(job.kind, TransformKind::kCamera);
      EXPECT_EQ(job.repeat, RepeatCount<C>(3));
      EXPECT_EQ(job.matrix, MatrixIndex(77));
      packets.push_back(generator.packet_of(job));
      under_way.push_back(job);
    }
    if (under_way.empty()) break;
    EXPECT_EQ(generator.dones(), 0u) << "a packet is still under way";
    const std::size_t i = test::below(random, static_cast<unsigned>(under_way.size()));
    generator.give_back(under_way[i].packet);
    under_way.erase(under_way.begin() + static_cast<std::ptrdiff_t>(i));
  }
  EXPECT_EQ(generator.dones(), 1u);
  return {std::move(packets), generator.skipped()};
}

template <class C>
void expect_every_pixel_once(const Image& image) {
  SCOPED_TRACE(testing::Message() << image.width << "x" << image.height << " "
                                  << (image.scanline ? "scanline" : "Morton") << ", "
                                  << image.packets << " packets of " << kRays<C>);
  std::vector<unsigned char> seen(std::size_t{image.width} * image.height);
  std::size_t outside = 0;
  for (const Packet<C>& packet : frame<C>(image).packets) {
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      if (!packet.active.bit(ray)) continue;
      const unsigned x = packet.x + ray % packet_columns(kRays<C>);
      const unsigned y = packet.y + ray / packet_columns(kRays<C>);
      if (x < image.width && y < image.height) {
        ++seen[std::size_t{y} * image.width + x];
      } else {
        ++outside;
      }
    }
  }
  EXPECT_EQ(outside, 0u);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
}

template <class C>
class RayGenerationTest : public testing::Test {};
TYPED_TEST_SUITE(RayGenerationTest, test::PacketSizes<Four>);

TYPED_TEST(RayGenerationTest, MakesEveryPixelOnce) {
  for (const bool scanline : {false, true}) {
    for (const unsigned packets : {1, 5, 64}) {
      for (unsigned width = 1; width <= 9; ++width) {
        for (unsigned height = 1; height <= 9; ++height) {
          expect_every_pixel_once<TypeParam>({width, height, scanline, packets});
        }
      }
    }
    for (const auto& [width, height] :
         {std::pair{640u, 3u}, {511u, 4u}, {512u, 384u}, {1u, 300u}, {257u, 129u}}) {
      expect_every_pixel_once<TypeParam>({width, height, scanline, 32});
    }
  }
}

TYPED_TEST(RayGenerationTest, MakesEveryPixelOfTheLargestImages) {
  for (const auto& [width, height] :
       {std::pair{1024u, 1024u}, {1023u, 2u}, {1024u, 1u}, {1u, 1024u}, {2u, 1023u}, {1022u, 5u}}) {
    for (const bool scanline : {false, true}) {
      expect_every_pixel_once<TypeParam>({width, height, scanline, 32});
    }
  }
}

/// Bits of the pixel's x at the even, of its y at the odd places.
std::uint64_t interleaved(unsigned x, unsigned y) {
  std::uint64_t key = 0;
  for (unsigned bit = 0; bit < 10; ++bit) {
    key |= std::uint64_t{x >> bit & 1} << (2 * bit);
    key |= std::uint64_t{y >> bit & 1} << (2 * bit + 1);
  }
  return key;
}

TYPED_TEST(RayGenerationTest, MortonOrderInterleavesTheBitsWithXLowest) {
  for (const auto& [width, height] : {std::pair{64u, 64u}, {37u, 90u}, {512u, 10u}}) {
    const Image image = {width, height, false, 1};
    const auto packets = frame<TypeParam>(image).packets;
    ASSERT_EQ(packets.size(), packets_of<TypeParam>(image));
    EXPECT_TRUE(std::ranges::is_sorted(
        packets, {}, [](const auto& packet) { return interleaved(packet.x, packet.y); }));
  }
}

TEST(RayGeneration, BeginsWithTwoZsSideBySide) {
  // The first eight packets of figure 7.4.
  const auto start = frame<Four>({64, 64, false, 1}).packets;
  const unsigned expected[8][2] = {{0, 0}, {2, 0}, {0, 2}, {2, 2}, {4, 0}, {6, 0}, {4, 2}, {6, 2}};
  for (unsigned i = 0; i < 8; ++i) {
    EXPECT_EQ(start[i].x, expected[i][0]) << i;
    EXPECT_EQ(start[i].y, expected[i][1]) << i;
  }
}

TYPED_TEST(RayGenerationTest, PassesOverTwoPacketsOfABlockOutsideTheImage) {
  const Image image = {512, 384, false, 32};
  const std::size_t outside =
      packets_of<TypeParam>({512, 512, false, 32}) - packets_of<TypeParam>(image);
  constexpr std::size_t kBlock = 64;
  const std::size_t last_block = kBlock - 2;
  EXPECT_EQ(frame<TypeParam>(image).skipped, 2 * outside / kBlock + last_block);
}

TEST(RayGeneration, ScanlineOrderGoesLineByLine) {
  const auto packets = frame<Four>({7, 5, true, 1}).packets;
  ASSERT_EQ(packets.size(), 12u);
  for (unsigned i = 0; i < 12; ++i) {
    EXPECT_EQ(packets[i].x, 2 * (i % 4)) << i;
    EXPECT_EQ(packets[i].y, 2 * (i / 4)) << i;
  }
}

}  // namespace
}  // namespace dynrt
