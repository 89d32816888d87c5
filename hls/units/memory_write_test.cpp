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

template <unsigned Rays, unsigned Bytes>
struct Port : test::Config<8> {
  static constexpr unsigned kPacketRays = Rays;
  static constexpr MemoryPath kMemory = MemoryPath::kPort;
  static constexpr unsigned kPortBytes = Bytes;
};
/// The same core with banks.
template <class C>
struct InBanks : C {
  static constexpr MemoryPath kMemory = MemoryPath::kBanks;
};

using Words = std::map<std::pair<unsigned, unsigned>, std::uint32_t>;  ///< by bank and number

constexpr unsigned kWidth = 20;  ///< a pitch of its own, so that banks have the same
constexpr unsigned kHeight = 11;

template <class C>
class Shade {
 public:
  explicit Shade(bool hits) {
    FrameRegisters<C>& frame = bench_.value(bench_.unit.frame);
    frame.width = kWidth;
    frame.height = kHeight;
    frame.frame_base = 8;
    frame.write_hits = Word::from(hits);
    frame.background = 0x123456;
  }
  /// The steps of a packet, one after the other.
  void operator()(unsigned x, unsigned y, auto&& after_step) {
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
  auto& unit() { return bench_.unit; }
  auto& bench() { return bench_; }

 private:
  test::UnitBench<Shading<C>> bench_;
};

/// What a memory holds after the image's packets, and how it came there.
template <class C>
struct Written {
  Words words;
  unsigned beats = 0;
  unsigned bursts = 0;
  unsigned freed = 0;
};

template <class C>
Written<C> through_port(bool hits) {
  Shade<C> shade(hits);
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
      const BankWord at = bank_word(byte);
      std::uint32_t& word = written.words[{at.bank, at.word}];
      word |= static_cast<std::uint32_t>(beat.data[h].to_u64() << (8 * (byte % 4)));
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
  for (unsigned y = 0; y < kHeight; y += packet_rows(kRays<C>)) {
    for (unsigned x = 0; x < kWidth; x += packet_columns(kRays<C>)) shade(x, y, send);
  }
  return written;
}

template <class C>
Words in_banks(bool hits) {
  Shade<C> shade(hits);
  constexpr std::uint32_t kUntouched = 0xdeadbeef;
  for (auto& bank : shade.unit().bank) {
    std::ranges::fill(shade.bench().rows(bank), Word::from(kUntouched));
  }
  for (unsigned y = 0; y < kHeight; y += packet_rows(kRays<C>)) {
    for (unsigned x = 0; x < kWidth; x += packet_columns(kRays<C>)) shade(x, y, [] {});
  }
  Words words;
  for (unsigned b = 0; b < 3; ++b) {
    const auto& rows = shade.bench().rows(shade.unit().bank[b]);
    for (unsigned i = 0; i < 3 * kWidth * (kHeight + 1); ++i) {
      const auto word = static_cast<std::uint32_t>(rows[i].to_u64());
      if (word != kUntouched) words[{kFrameBank + b, i}] = word;
    }
  }
  return words;
}

template <class C>
class MemoryWrites : public testing::Test {};
using Ports = testing::Types<Port<4, 2>, Port<4, 16>, Port<8, 2>, Port<8, 8>, Port<8, 16>,
                             Port<8, 32>, Port<4, 32>, Port<16, 4>>;
TYPED_TEST_SUITE(MemoryWrites, Ports);

TYPED_TEST(MemoryWrites, HoldWhatTheBanksHold) {
  for (const bool hits : {false, true}) {
    const Written<TypeParam> written = through_port<TypeParam>(hits);
    EXPECT_EQ(written.words, in_banks<InBanks<TypeParam>>(hits));
    EXPECT_EQ(written.words.size(), kWidth * kHeight * (hits ? 7u : 1u));
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
  const unsigned row = 4 * packet_columns(kRays<TypeParam>);
  const unsigned rows = kWidth * kHeight * 4 / row;
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
