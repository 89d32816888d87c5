// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A Verilated ulx3s_board with models of the parts at its pins.
#pragma once

#include <verilated.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <span>
#include <stdexcept>
#include <vector>

#include "host/board/dvi_monitor.h"
#include "host/board/timed_top.h"
#include "host/error.h"
#include "host/ulx3s/simulated_ulx3s.h"
#include "sdram/sdram_chip.h"
#include "sdram/sdram_pin_timing.h"
#include "ulx3s/serial_pins.h"
#include "units/link_format.h"
#include "units/sdram_timing.h"

namespace dynrt::host {

/// `Top` is a Verilated ulx3s_board.
template <class Top>
class VerilatedUlx3s final : public SimulatedUlx3s {
 public:
  VerilatedUlx3s() : SimulatedUlx3s("the simulated ULX3S") {
    context_.randReset(2);
    top_.serial_i = 1;
    run_.add_clock(top_.clk_25mhz_i, kOscillator);
    top_.button_ni = 0;
    run_ps(1'000'000);
    top_.button_ni = 1;
    while (!chip_.is_set_up()) {
      if (run_.now() > kLongestSetUp) {
        throw std::logic_error(
            "the controller of the simulated ULX3S did not initialise its SDRAM within a "
            "millisecond");
      }
      run_ps(1'000'000);
    }
  }
  ~VerilatedUlx3s() override { top_.final(); }
  VerilatedUlx3s(const VerilatedUlx3s&) = delete;
  VerilatedUlx3s& operator=(const VerilatedUlx3s&) = delete;

  std::size_t write(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) serial_.send(byte);
    return bytes.size();
  }
  std::size_t read(std::span<std::uint8_t> bytes) override {
    std::deque<std::uint8_t>& received = serial_.received();
    const std::size_t count = std::min(bytes.size(), received.size());
    std::copy_n(received.begin(), count, bytes.begin());
    received.erase(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  void wait(bool /*to_write*/, Time deadline) override {
    while (serial_.received().empty() && now() < deadline) run_ps(kStep);
  }
  Time now() const override {
    return std::chrono::duration_cast<Time>(
        std::chrono::duration<double, std::pico>(static_cast<double>(run_.now())));
  }

  void run(Time time) override { run_ps(static_cast<Ps>(time.count()) * 1000); }
  std::vector<DisplayFrame> take_frames() override {
    std::vector<DisplayFrame> frames(
        monitor_.frames().begin() + static_cast<std::ptrdiff_t>(taken_), monitor_.frames().end());
    taken_ = monitor_.frames().size();
    return frames;
  }
  /// The lights of the board (ulx3s_board.v).
  unsigned lights() const { return top_.led_o; }
  SdramUse memory_use() const override {
    const verif::SdramCounters& c = chip_.counters();
    return {c.clocks, c.words_read, c.words_written, c.activations, c.refreshes};
  }

  void write(std::uint32_t address, std::span<const std::uint8_t> bytes) override {
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
      half(address + static_cast<std::uint32_t>(i)) =
          static_cast<std::uint16_t>(bytes[i] | bytes[i + 1] << 8);
    }
  }
  void read(std::uint32_t address, std::span<std::uint8_t> bytes) override {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::uint32_t at = address + static_cast<std::uint32_t>(i);
      bytes[i] = static_cast<std::uint8_t>(half(at & ~1u) >> (8 * (at & 1)));
    }
  }

 private:
  using Ps = std::uint64_t;
  static constexpr Ps kOscillator = 40'000;  ///< a period
  static constexpr unsigned kMemoryClock = Sdram100::kClockPicoseconds;
  static constexpr Ps kLineBit = 1'000'000'000'000 / kLinkBaud;  ///< the host's, not the board's
  static constexpr Ps kStep = 10'000'000;
  static constexpr Ps kLongestSetUp = 1'000'000'000;

  /// Rows of 1 KB go round the banks (units/sdram_tokens.h).
  std::uint16_t& half(std::uint32_t address) {
    return chip_.word(address >> 10 & 3, address >> 12, address >> 1 & 511);
  }

  void run_ps(Ps time) {
    run_.run(
        time, [this](Ps now) { look(now); },
        [this](Ps next) { top_.sdram_dq_i = pins_.word_before(next); });
    std::string fault = pins_.fault();
    if (fault.empty() && !chip_.faults().empty()) fault = chip_.faults().front().text;
    if (!fault.empty()) {
      refuse("the simulated ULX3S breaks a rule of its SDRAM's data sheet: {}", fault);
    }
  }
  void look(Ps now) {
    monitor_.sample(now, {top_.dvi_p_o, top_.dvi_n_o});
    serial_.sample(now, top_.serial_o != 0);
    top_.serial_i = serial_.drive(now);
    verif::SdramChipPins pins{.cke = top_.sdram_cke_o != 0,
                              .cs_n = top_.sdram_cs_no != 0,
                              .ras_n = top_.sdram_ras_no != 0,
                              .cas_n = top_.sdram_cas_no != 0,
                              .we_n = top_.sdram_we_no != 0,
                              .bank = top_.sdram_bank_o,
                              .address = top_.sdram_addr_o,
                              .dqm = top_.sdram_dqm_o};
    if (top_.sdram_dq_float_o == 0) pins.dq = top_.sdram_dq_o;
    pins_.drive(now, pins);
    if (top_.sdram_clk_o != 0 && !clock_high_) {
      chip_.clock(pins);
      pins_.clock(now, chip_.dq());
    }
    clock_high_ = top_.sdram_clk_o != 0;
  }

  VerilatedContext context_;
  Top top_{&context_};
  TimedTop<Top> run_{top_};
  verif::SdramChip chip_{kAnySdram, kMemoryClock};
  verif::SdramPinTiming pins_{kAnySdram, Sdram100::kCasLatency};
  SerialPins serial_{kLineBit};
  DviMonitor monitor_;
  std::size_t taken_ = 0;
  bool clock_high_ = false;
};

}  // namespace dynrt::host
