// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A unit's RTL against its C++, for every unit alike: some runs with random stalls, and one with
// none that also measures the throughput. State that the RTL has not written (RAMs, registers
// before the reset) is random, so a unit that relies on it fails.
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdint>

#include DYNRT_CONFIG_HEADER
#include "cosim/bench.h"
#include "units/packet.h"
#include "units/start.h"

namespace dynrt::cosim {

using hls::cosim::Bench;
using hls::cosim::Random;
using hls::cosim::Report;

/// The configuration whose Verilog is tested.
using C = dynrt::config::DYNRT_CONFIG;

/// How much is run.
struct Amount {
  unsigned runs;
  std::uint64_t transactions;  ///< in each run
};
inline constexpr Amount kQuick{10, 20'000};
inline constexpr Amount kSlow{20, 150'000};

/// The settings of one run.
struct Run {
  unsigned number;
  bool full_speed;  ///< no stalls; the packets come in their order, so that none has to wait
};

/// Sets up `Dut`'s bench for each run by `setup(bench, run)` and runs it.
template <class Unit, class Dut, class Visit, class Setup>
void cosimulate(const char* name, Amount amount, Visit visit, Setup setup) {
  for (unsigned number = 0; number < amount.runs; ++number) {
    const Run run{number, number == 0};
    const std::uint64_t seed = 1000 * amount.transactions + number;
    VerilatedContext context;
    context.randReset(2);
    context.randSeed(static_cast<int>(seed % 0x7fff'ffff) + 1);
    Dut dut(&context);
    Bench<Unit> bench(name, dut, visit);
    setup(bench, run);
    const Report report = bench.run({.seed = seed,
                                     .transactions = amount.transactions,
                                     .stall_inputs = !run.full_speed,
                                     .stall_outputs = !run.full_speed,
                                     .reset_clocks = kResetClocks});
    ASSERT_TRUE(report.ok) << report.text;
    ASSERT_EQ(report.transactions, amount.transactions);
    if (run.full_speed) {
      constexpr std::uint64_t kLatency = 100;
      EXPECT_LE(report.clocks, amount.transactions + kLatency)
          << name << ": one transaction a clock";
    }
  }
}

/// Two tests of a unit's module, quick and slow. SETUP(bench, run) shapes the tokens.
#define DYNRT_COSIM(SUITE, UNIT, MODULE, SETUP)                                        \
  void cosimulate_##MODULE(dynrt::cosim::Amount amount) {                              \
    dynrt::cosim::cosimulate<UNIT, V##MODULE>(                                         \
        #MODULE, amount, [](auto& v, auto& f) { visit_ports_##MODULE(v, f); }, SETUP); \
  }                                                                                    \
  TEST(SUITE, RtlIsTheModel) { cosimulate_##MODULE(dynrt::cosim::kQuick); }            \
  TEST(SUITE, SlowRtlIsTheModel) { cosimulate_##MODULE(dynrt::cosim::kSlow); }

/// A token's level; 0 if tokens have none.
template <class Field>
std::size_t level_of(const Field& level) {
  if constexpr (requires { level.to_u64(); }) {
    return level.to_u64();
  } else {
    return 0;
  }
}

/// Which packet the next token belongs to.
class Packets {
 public:
  explicit Packets(const Run& run) : in_order_(run.full_speed) {}
  PacketId<C> next(Random& random) {
    return PacketId<C>::from(in_order_ ? number_++ : random.below(C::kPackets));
  }

 private:
  bool in_order_;
  std::uint64_t number_ = 0;
};

/// For an enum of `values` values.
template <class E>
E any_of(Random& random, unsigned values) {
  return static_cast<E>(random.below(values));
}
template <unsigned W>
uint<W> number_below(Random& random, std::uint64_t limit) {
  return uint<W>::from(random.below(limit));
}

}  // namespace dynrt::cosim
