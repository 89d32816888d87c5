// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The share of the chip's peak that the controller reaches, by its native model: reads that follow
// each other and random ones, as fast as the port takes them, and random reads with the writes of a
// picture. docs/explanation/sdram.md has the figures.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "sdram/sdram_bench.h"

namespace dynrt::verif {
namespace {

using Types = SdramPortTypes<16>;

/// What is asked for, and the least share that is to be reached.
struct Load {
  const char* name;
  unsigned bytes;  ///< of a read
  bool random;
  double written = 0;  ///< MB/s, in bursts of 8 bytes: four pixels of 16 bits
  double least;        ///< percent of the peak
};

/// Pixels of packets of eight rays, four in each of two rows of a picture of 512.
class PixelWrites {
 public:
  explicit PixelWrites(double rate) : nanoseconds_(rate > 0 ? 8 / rate * 1000 : 0) {}
  void pass(double now) {
    for (; nanoseconds_ > 0 && due_ <= now; due_ += nanoseconds_, ++number_) {
      const unsigned row = number_ / 256 * 2 + number_ % 2;
      waiting_.push_back((1u << 24) + row % 384 * 1024 + number_ / 2 % 128 * 8);
    }
  }
  std::optional<Types::Write> next() {
    if (waiting_.empty()) return std::nullopt;
    Types::Write write;
    write.address = waiting_.front() & ~15u;
    write.mask = (waiting_.front() & 8) != 0 ? 0xf0 : 0x0f;
    for (auto& half : write.data) half = static_cast<std::uint16_t>(number_ + write.address);
    waiting_.pop_front();
    return write;
  }

 private:
  double nanoseconds_;
  double due_ = 0;
  unsigned number_ = 0;
  std::deque<std::uint32_t> waiting_;
};

template <class S>
void expect_share(const Load& load) {
  constexpr double kNanoseconds = S::kClockPicoseconds / 1000.;
  constexpr unsigned kPauseTurns = 100;
  constexpr unsigned kClocks = 100'000;
  constexpr unsigned kStages = 2;
  SdramPart part = kAnySdram;
  part.pause = 2 * kPauseTurns * S::kClockPicoseconds;
  SdramBench<16> bench(SdramChip(part, S::kClockPicoseconds));
  SdramPort<S, 16> port(kStages, kPauseTurns);
  std::mt19937 random(1);
  std::uint32_t next = 0;
  std::uint32_t id = 0;
  PixelWrites writes(load.written);
  const SdramTraffic<16> traffic{
      .read = [&]() -> std::optional<Types::Read> {
        const auto place = static_cast<std::uint32_t>(random());
        next = (load.random ? place : next + load.bytes) & 0xff'ffff & ~(load.bytes - 1);
        return Types::Read{id++ & 0x3ff, next, load.bytes / 16 - 1};
      },
      .write = [&] { return writes.next(); },
      .beat_ready =
          [&] {
            writes.pass(static_cast<double>(bench.clocks()) * kNanoseconds);
            return true;
          }};
  while (!bench.chip().is_set_up()) bench.clock(port, traffic);
  bench.chip().clear_counters();
  for (unsigned i = 0; i < kClocks; ++i) bench.clock(port, traffic);
  EXPECT_EQ(bench.report(), "");
  const SdramCounters& c = bench.chip().counters();
  const double share = 100 * static_cast<double>(c.busy()) / kClocks;
  const auto rate = [&](std::uint64_t words) {
    return static_cast<double>(words) * 2000 / kClocks / kNanoseconds;
  };
  fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {:.1f} % |\n", load.name, 1000 / kNanoseconds,
             rate(c.words_read), rate(c.words_written), share);
  EXPECT_GE(share, load.least) << load.name;
}

TEST(SdramShare, IsThatOfThePeak) {
  fmt::print("| | MHz | MB/s read | written | of the peak |\n");
  for (const Load& load :
       {Load{.name = "reads that follow each other", .bytes = 16, .random = false, .least = 97},
        Load{.name = "random reads of 32 bytes", .bytes = 32, .random = true, .least = 97},
        Load{.name = "random reads of 16 bytes", .bytes = 16, .random = true, .least = 96},
        Load{.name = "the same, with pixels written",
             .bytes = 16,
             .random = true,
             .written = 30,
             .least = 93}}) {
    expect_share<Sdram133>(load);
    expect_share<Sdram100>(load);
  }
}

}  // namespace
}  // namespace dynrt::verif
