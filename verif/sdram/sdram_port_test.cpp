// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The SDRAM controller behind its port, the Verilog and its native model in step: every output of
// every clock is equal, every word that is read is the one that was written, and the chip of every
// speed grade finds nothing that its data sheet forbids.
#include <gtest/gtest.h>

#include "Vsdram_100_16.h"
#include "Vsdram_100_8.h"
#include "Vsdram_133_16.h"
#include "Vsdram_133_32.h"
#include "Vsdram_133_8.h"
#include "sdram/sdram_bench.h"
#include "sdram/sdram_rtl.h"
#include "sdram/sdram_stages.h"
#include "sdram/sdram_traffic.h"

namespace dynrt::verif {
namespace {

/// The schedule of the controller for a clock.
template <class S>
constexpr const char* kSchedule = SDRAM_133_SCHEDULE;
template <>
constexpr const char* kSchedule<Sdram100> = SDRAM_100_SCHEDULE;

template <class V, class S, unsigned PortBytes>
struct Variant {
  using Verilated = V;
  using Sdram = S;
  static constexpr unsigned kPortBytes = PortBytes;
};
using Variants =
    testing::Types<Variant<Vsdram_133_16, Sdram133, 16>, Variant<Vsdram_133_8, Sdram133, 8>,
                   Variant<Vsdram_133_32, Sdram133, 32>, Variant<Vsdram_100_16, Sdram100, 16>,
                   Variant<Vsdram_100_8, Sdram100, 8>>;

constexpr unsigned kPauseTurns = 40;

/// Runs both in step and reports the first difference.
template <class T>
class Pair {
 public:
  using Types = SdramPortTypes<T::kPortBytes>;
  explicit Pair(int seed)
      : rtl_(kPauseTurns, seed), model_(stages_of(kSchedule<typename T::Sdram>), kPauseTurns) {}
  typename Types::Outputs outputs(const typename Types::Inputs& in) {
    const auto rtl = rtl_.outputs(in);
    const auto model = model_.outputs(in);
    const bool equal = rtl.read_ready == model.read_ready && rtl.write_ready == model.write_ready &&
                       rtl.beat == model.beat && rtl.pins == model.pins;
    if (!equal && difference_.empty()) {
      difference_ = fmt::format(
          "clock {}: RTL and model differ: ready {}{} and {}{}, beat {} and {}, command {} and {}, "
          "bank "
          "{} and {}, address {} and {}, dqm {} and {}, drives {} and {}, dq {} and {}",
          clocks_, rtl.read_ready, rtl.write_ready, model.read_ready, model.write_ready,
          rtl.beat.has_value(), model.beat.has_value(), static_cast<unsigned>(rtl.pins.command),
          static_cast<unsigned>(model.pins.command), rtl.pins.bank, model.pins.bank,
          rtl.pins.address, model.pins.address, rtl.pins.dqm, model.pins.dqm, rtl.pins.drives,
          model.pins.drives, rtl.pins.dq, model.pins.dq);
    }
    return rtl;
  }
  void clock(const typename Types::Inputs& in) {
    rtl_.clock(in);
    model_.clock(in);
    ++clocks_;
  }
  const std::string& difference() const { return difference_; }

 private:
  SdramRtl<typename T::Verilated, T::kPortBytes> rtl_;
  SdramPort<typename T::Sdram, T::kPortBytes> model_;
  std::uint64_t clocks_ = 0;
  std::string difference_;
};

SdramPart with_pause(SdramPart part, unsigned clock) {
  part.pause = 2 * kPauseTurns * clock;
  return part;
}

template <class T>
class SdramPortTest : public testing::Test {
 protected:
  static constexpr unsigned kClock = T::Sdram::kClockPicoseconds;
  using Bench = SdramBench<T::kPortBytes>;

  void run(const SdramPart& part, unsigned seed, unsigned clocks) {
    Bench bench(SdramChip(with_pause(part, kClock), kClock));
    Pair<T> pair(static_cast<int>(seed));
    RandomTraffic<T::kPortBytes> random(seed);
    const auto traffic = random.traffic();
    for (unsigned i = 0; i < clocks && pair.difference().empty(); ++i) bench.clock(pair, traffic);
    random.stop();
    for (unsigned i = 0; i < 2000 && !bench.is_idle(); ++i) bench.clock(pair, traffic);
    EXPECT_TRUE(bench.is_idle()) << "seed " << seed << ": answers are missing";
    EXPECT_EQ(pair.difference(), "") << "seed " << seed;
    EXPECT_EQ(bench.report(), "") << "seed " << seed;
    const SdramCounters& c = bench.chip().counters();
    EXPECT_GT(bench.beats(), clocks / 100) << "seed " << seed;
    EXPECT_GT(c.words_written, clocks / 100) << "seed " << seed;
    EXPECT_GT(c.refreshes, clocks / 1100) << "seed " << seed;
    EXPECT_GT(c.activations, c.refreshes) << "seed " << seed;
  }
};
struct Names {
  template <class T>
  static std::string GetName(int) {
    return fmt::format("{}ps_{}bytes", T::Sdram::kClockPicoseconds, T::kPortBytes);
  }
};
TYPED_TEST_SUITE(SdramPortTest, Variants, Names);

TYPED_TEST(SdramPortTest, RtlAndTwinAndChipAgree) {
  for (const SdramPart& part :
       {kIs42s16160Grade6, kIs42s16160Grade7, kAs4c32m16Grade6, kAs4c32m16Grade7}) {
    this->run(part, part.rcd, 20'000);
  }
}

TYPED_TEST(SdramPortTest, SlowRtlAndTwinAndChipAgree) {
  for (unsigned seed = 1; seed <= 5; ++seed) this->run(kAnySdram, seed, 300'000);
}

}  // namespace
}  // namespace dynrt::verif
