// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The memory of the ULX3S, ulx3s_memory, with the chip behind it, whose clock and the core's have
// any ratio and phase. Random reads and writes go in; every beat has what was written before, if
// the read waited for the writes to the same bytes to be idle; no clock breaks a rule of the chip.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <string>

#include "Vulx3s_memory.h"
#include "sdram/port_scoreboard.h"
#include "sdram/sdram_bench.h"
#include "sdram/sdram_chip.h"
#include "sdram/sdram_traffic.h"

namespace dynrt::verif {
namespace {

constexpr unsigned kBytes = 8;  ///< of a beat, as the test's CMakeLists.txt has it
constexpr unsigned kPauseTurns = 40;
using Traffic = SdramTraffic<kBytes>;
using Types = SdramPortTypes<kBytes>;

struct Clocks {
  std::uint64_t core, chip;  ///< periods in ps
  std::uint64_t phase;       ///< of the chip's, in ps
};

SdramPart part(const Clocks& clocks) {
  SdramPart part = kAnySdram;
  part.pause = 2 * kPauseTurns * static_cast<unsigned>(clocks.chip);
  return part;
}

/// The bytes of requests, by the address of their beats.
class Places {
 public:
  void add(std::uint32_t address, unsigned beats) {
    for (unsigned i = 0; i < beats; ++i) places_.insert(address + i * kBytes);
  }
  bool meet(std::uint32_t address, unsigned beats) const {
    for (unsigned i = 0; i < beats; ++i) {
      if (places_.contains(address + i * kBytes)) return true;
    }
    return false;
  }
  void clear() { places_.clear(); }

 private:
  std::set<std::uint32_t> places_;
};

class Memory {
 public:
  Memory(const Clocks& clocks, unsigned seed)
      : clocks_(clocks),
        chip_(part(clocks), static_cast<unsigned>(clocks.chip)),
        expected_(contents_of(chip_)),
        next_chip_(clocks.phase) {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed));
    v_.rst_ni = 0;
    v_.sdram_rst_ni = 0;
    for (unsigned i = 0; i < 64; ++i) edge({});
    v_.rst_ni = 1;
    v_.sdram_rst_ni = 1;
  }
  ~Memory() { v_.final(); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  void run(unsigned core_clocks, const Traffic& traffic) {
    for (const std::uint64_t end = core_clocks_ + core_clocks; core_clocks_ < end;) edge(traffic);
  }
  bool is_idle() const { return expected_.is_idle() && !read_ && !write_; }
  bool writes_idle() const { return v_.writes_idle_o != 0; }
  std::string report() const {
    std::string text;
    for (const std::string& mistake : expected_.mistakes()) text += mistake + "\n";
    for (const SdramFault& fault : chip_.faults()) text += fault.text + "\n";
    return text;
  }
  const PortScoreboard<kBytes>& expected() const { return expected_; }
  const SdramCounters& counters() const { return chip_.counters(); }
  /// Clocks of reads that waited for writes to the same bytes.
  unsigned waited() const { return waited_; }

 private:
  /// The next edge of either clock, or of both at once.
  void edge(const Traffic& traffic) {
    const std::uint64_t now = std::min(next_core_, next_chip_);
    const bool core = now == next_core_, chip = now == next_chip_;
    if (core) offer(traffic);
    v_.sdram_dq_i = chip_.dq().value_or(0xdead);
    v_.clk_i = core ? 0 : v_.clk_i;
    v_.sdram_clk_i = chip ? 0 : v_.sdram_clk_i;
    v_.eval();
    if (core) take();
    if (chip) chip_.clock(pins());
    v_.clk_i = core ? 1 : v_.clk_i;
    v_.sdram_clk_i = chip ? 1 : v_.sdram_clk_i;
    v_.eval();
    if (core) next_core_ += clocks_.core;
    if (chip) next_chip_ += clocks_.chip;
    if (core) ++core_clocks_;
  }
  /// Nothing is offered that meets what is under way to the other side.
  void offer(const Traffic& traffic) {
    if (!read_) v_.read_valid_i = 0;
    if (!write_) v_.write_valid_i = 0;
    if (writes_idle() && v_.write_valid_i == 0) written_.clear();
    if (expected_.is_idle() && v_.read_valid_i == 0) asked_.clear();
    if (!read_) read_ = traffic.read();
    if (!write_) write_ = traffic.write();
    if (read_ && v_.read_valid_i == 0) {
      v_.read_valid_i = !written_.meet(read_->address, read_->last + 1);
      if (v_.read_valid_i == 0) ++waited_;
      if (v_.read_valid_i != 0) asked_.add(read_->address, read_->last + 1);
    }
    if (write_ && v_.write_valid_i == 0) {
      v_.write_valid_i = !asked_.meet(write_->address, 1);
      if (v_.write_valid_i != 0) written_.add(write_->address, 1);
    }
    if (read_) {
      v_.read_id_i = static_cast<SData>(read_->id);
      v_.read_address_i = read_->address;
      v_.read_last_i = static_cast<CData>(read_->last);
    }
    if (write_) {
      v_.write_address_i = write_->address;
      v_.write_mask_i = static_cast<CData>(write_->mask);
      std::memcpy(&v_.write_data_i, write_->data.data(), kBytes);
    }
    v_.beat_ready_i = traffic.beat_ready();
  }
  void take() {
    if (v_.read_valid_i != 0 && v_.read_ready_o != 0) {
      expected_.expect(*read_);
      read_.reset();
    }
    if (v_.write_valid_i != 0 && v_.write_ready_o != 0) {
      expected_.store(*write_);
      write_.reset();
    }
    if (v_.beat_valid_o != 0 && v_.beat_ready_i != 0) {
      Types::Beat beat{.id = v_.beat_id_o, .data = {}, .last = v_.beat_last_o != 0};
      std::memcpy(beat.data.data(), &v_.beat_data_o, kBytes);
      expected_.compare(beat, core_clocks_);
    }
  }
  SdramChipPins pins() const {
    SdramChipPins pins{.ras_n = v_.sdram_ras_no != 0,
                       .cas_n = v_.sdram_cas_no != 0,
                       .we_n = v_.sdram_we_no != 0,
                       .bank = v_.sdram_ba_o,
                       .address = v_.sdram_a_o,
                       .dqm = v_.sdram_dqm_o};
    if (v_.sdram_dq_float_o == 0) pins.dq = v_.sdram_dq_o;
    return pins;
  }

  Clocks clocks_;
  VerilatedContext context_;
  Vulx3s_memory v_{&context_};
  SdramChip chip_;
  PortScoreboard<kBytes> expected_;
  std::optional<Types::Read> read_;
  std::optional<Types::Write> write_;
  unsigned waited_ = 0;
  Places written_, asked_;
  std::uint64_t next_core_ = 0;
  std::uint64_t next_chip_ = 0;
  std::uint64_t core_clocks_ = 0;
};

class Ulx3sMemory : public testing::TestWithParam<Clocks> {
 protected:
  static void run(unsigned seed, unsigned core_clocks) {
    Memory memory(GetParam(), seed);
    RandomTraffic<kBytes> random(seed);
    const Traffic traffic = random.traffic();
    memory.run(core_clocks, traffic);
    random.stop();
    memory.run(4000, traffic);
    EXPECT_TRUE(memory.is_idle()) << "seed " << seed << ": answers are missing";
    EXPECT_TRUE(memory.writes_idle()) << "seed " << seed << ": a write never arrived";
    EXPECT_EQ(memory.report(), "") << "seed " << seed;
    EXPECT_GT(memory.expected().beats(), core_clocks / 50) << "seed " << seed;
    EXPECT_GT(memory.counters().words_written, core_clocks / 50) << "seed " << seed;
    EXPECT_GT(memory.waited(), core_clocks / 2000) << "seed " << seed;
  }
};

TEST_P(Ulx3sMemory, ReadsWhatWasWrittenBefore) {
  for (unsigned seed = 1; seed <= 3; ++seed) run(seed, 20'000);
}

// The clocks of the board, which meet every 80 ns; a slower core; a faster one; the same clock at
// any phase.
INSTANTIATE_TEST_SUITE_P(Clocks, Ulx3sMemory,
                         testing::Values(Clocks{16'000, 10'000, 0}, Clocks{23'000, 10'000, 1'000},
                                         Clocks{7'000, 10'000, 3'000}, Clocks{10'000, 10'000, 0},
                                         Clocks{10'000, 10'000, 4'000}),
                         [](const auto& info) {
                           return fmt::format("core{}ps_chip{}ps_phase{}ps", info.param.core,
                                              info.param.chip, info.param.phase);
                         });

}  // namespace
}  // namespace dynrt::verif
