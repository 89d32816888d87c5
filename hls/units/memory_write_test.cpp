// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From the shading of packets to the beats at the memory's port.
#include "units/memory_write.h"

#include <algorithm>
#include <map>
#include <vector>

#include "units/shading.h"
#include "units/test_bench.h"

namespace dynrt {
namespace {

template <unsigned Rays, unsigned Bytes, unsigned PixelBits = 32>
struct Port : test::Config<8> {
  static constexpr unsigned kPacketRays = Rays;
  static constexpr MemoryPath kMemory = MemoryPath::kPort;
  static constexpr unsigned kPortBytes = Bytes;
  static constexpr unsigned kPixelBits = PixelBits;
};
/// The same core with banks.
template <class C>
struct InBanks : C {
  static constexpr MemoryPath kMemory = MemoryPath::kBanks;
  static constexpr unsigned kPixelBits = 32;
};

using Halves = std::map<unsigned, std::uint16_t>;  ///< of words, by their byte

constexpr unsigned kWidth = 20;
constexpr unsigned kHeight = 11;
constexpr unsigned kFirstPixel = 8;

template <class C>
class Shade {
 public:
  explicit Shade(bool hits, unsigned width = kWidth) : width_(width) {
    FrameRegisters<C>& frame = bench_.value(bench_.unit.frame);
    frame.width = Word::from(width);
    frame.height = kHeight;
    frame.frame_base = kFirstPixel;
    frame.write_hits = Word::from(hits);
    frame.background = 0x123456;
  }
  /// The steps of every packet of the image, one after the other.
  void all(auto&& after_step) {
    for (unsigned y = 0; y < kHeight; y += packet_rows(kRays<C>)) {
      for (unsigned x = 0; x < width_; x += packet_columns(kRays<C>)) packet(x, y, after_step);
    }
  }
  auto& unit() { return bench_.unit; }
  auto& bench() { return bench_; }

 private:
  void packet(unsigned x, unsigned y, auto&& after_step) {
    test::Random random(17 * y + x);
    for (unsigned ray = 0; ray < kRays<C>; ++ray) {
      bench_.rows(bench_.unit.hit)[ray] = test::random_token<HitRecord<C>>(random);
    }
    bench_.rows(bench_.unit.position)[0] = {uint<10>::from(x), uint<10>::from(y)};
    ShadeJob<C> job;
    for (RepeatCount<C> i; i <= kLastWrite<C>; i = hls::next(i)) {
      bench_.feed(bench_.unit.job, Repeated<ShadeJob<C>>{i, i == kLastWrite<C>, job});
      bench_.run();
      after_step();
    }
  }

  unsigned width_;
  test::UnitBench<Shading<C>> bench_;
};

/// What a memory holds after the image's packets, and how it came there.
template <class C>
struct Written {
  Halves halves;
  unsigned beats = 0;
  unsigned bursts = 0;
  unsigned freed = 0;
};

template <class C>
Written<C> through_port(bool hits, unsigned width = kWidth) {
  Shade<C> shade(hits, width);
  test::UnitBench<MemoryWrite<C>> write;
  Written<C> written;
  std::uint64_t left = 0;
  const auto store = [&](const PortWrite<C>& beat) {
    EXPECT_EQ(beat.address.to_u64() % kBeatBytes<C>, 0u);
    ++written.beats;
    EXPECT_TRUE(left == 0 || left == beat.left.to_u64() + 1) << "a beat of another burst";
    left = beat.left.to_u64();
    written.bursts += left == 0;
    for (unsigned h = 0; h < beat.data.size(); ++h) {
      if ((beat.mask.to_u64() >> h & 1) == 0) continue;
      const unsigned byte = static_cast<unsigned>(beat.address.to_u64()) + 2 * h;
      const auto half = static_cast<std::uint16_t>(beat.data[h].to_u64());
      EXPECT_TRUE(written.halves.emplace(byte, half).second) << "written twice";
    }
  };
  const auto send = [&] {
    for (const WriteBurst<C>& burst : shade.bench().take(shade.unit().burst)) {
      for (std::uint64_t i = 0; i <= burst.repeat.to_u64(); ++i) {
        Repeated<WriteBurst<C>> numbered;
        numbered.index = decltype(numbered.index)::from(i);
        numbered.last = i == burst.repeat.to_u64();
        numbered.job = burst;
        write.feed(write.unit.burst, numbered);
        write.run();
      }
      for (const PortWrite<C>& beat : write.take(write.unit.write)) store(beat);
      written.freed += static_cast<unsigned>(write.take(write.unit.free).size());
    }
  };
  shade.all(send);
  return written;
}

void put(Halves& halves, unsigned byte, std::uint64_t bits, unsigned bytes) {
  for (unsigned i = 0; i < bytes; i += 2) {
    halves[byte + i] = static_cast<std::uint16_t>(bits >> (8 * i));
  }
}

/// What a core with banks writes, where the port has it. Rows follow each other in banks.
template <class C>
Halves from_banks(bool hits, unsigned width) {
  using Pixel = PixelOf<C>;
  Shade<InBanks<C>> shade(hits, width);
  constexpr std::uint32_t kUntouched = 0xdeadbeef;
  for (auto& bank : shade.unit().bank) {
    std::ranges::fill(shade.bench().rows(bank), Word::from(kUntouched));
  }
  shade.all([] {});
  Halves halves;
  const auto place = [&](unsigned pixel) {
    return pixel / width * row_pitch(width) + pixel % width;
  };
  for (unsigned pixel = 0; pixel < width * kHeight; ++pixel) {
    const Word colour = shade.bench().rows(shade.unit().bank[0])[kFirstPixel + pixel];
    EXPECT_NE(colour.to_u64(), kUntouched);
    put(halves, kPixelsAt + (kFirstPixel + place(pixel)) * Pixel::kBytes,
        Pixel::of(colour).to_u64(), Pixel::kBytes);
    for (unsigned i = 0; hits && i < 2 * kHitWords; ++i) {
      const auto& bank = shade.bench().rows(shade.unit().bank[1 + i % 2]);
      put(halves, kHitsAt + 8 * kHitWords * place(pixel) + 4 * i,
          bank[kHitWords * pixel + i / 2].to_u64(), 4);
    }
  }
  return halves;
}

template <class C>
class MemoryWrites : public testing::Test {};
using Ports = testing::Types<Port<4, 2>, Port<4, 16>, Port<8, 2>, Port<8, 8>, Port<8, 16>,
                             Port<8, 32>, Port<4, 32>, Port<16, 4>, Port<4, 2, 16>, Port<4, 8, 16>,
                             Port<4, 16, 16>, Port<4, 32, 16>, Port<8, 2, 16>, Port<8, 8, 16>,
                             Port<8, 16, 16>, Port<8, 32, 16>, Port<16, 4, 16>>;
TYPED_TEST_SUITE(MemoryWrites, Ports);

TYPED_TEST(MemoryWrites, HoldWhatTheBanksHold) {
  for (const unsigned width : {kWidth, 1u, 18u, 21u, 23u}) {
    for (const bool hits : {false, true}) {
      SCOPED_TRACE(width);
      const Written<TypeParam> written = through_port<TypeParam>(hits, width);
      EXPECT_EQ(written.halves, from_banks<TypeParam>(hits, width));
      const unsigned bytes = PixelOf<TypeParam>::kBytes + (hits ? 8 * kHitWords : 0);
      EXPECT_EQ(written.halves.size(), width * kHeight * bytes / 2);
    }
  }
}

TYPED_TEST(MemoryWrites, FreeEachPacketOnce) {
  constexpr unsigned kRows = packet_rows(kRays<TypeParam>);
  constexpr unsigned kPacketsOfImage =
      kWidth / packet_columns(kRays<TypeParam>) * ((kHeight + kRows - 1) / kRows);
  EXPECT_EQ(through_port<TypeParam>(false).freed, kPacketsOfImage);
  EXPECT_EQ(through_port<TypeParam>(true).freed, kPacketsOfImage);
}

TYPED_TEST(MemoryWrites, AreGatheredIntoBursts) {
  const auto beats = [](unsigned bytes) { return std::max(bytes / kBeatBytes<TypeParam>, 1u); };
  const unsigned row = PixelOf<TypeParam>::kBytes * packet_columns(kRays<TypeParam>);
  const unsigned rows = kWidth * kHeight / packet_columns(kRays<TypeParam>);
  const Written<TypeParam> pixels = through_port<TypeParam>(false);
  EXPECT_EQ(pixels.bursts, rows);
  EXPECT_EQ(pixels.beats, rows * beats(row));
  const Written<TypeParam> all = through_port<TypeParam>(true);
  const unsigned pairs = kWidth * kHeight * 3 / 2;
  EXPECT_EQ(all.bursts, rows + pairs);
  EXPECT_EQ(all.beats, rows * beats(row) + pairs * beats(kWriteBytes));
}

}  // namespace
}  // namespace dynrt
