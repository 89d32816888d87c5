// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A Verilated dynrt_board with its SRAM banks, its bus master and its clock gate. V is the
// Verilated class, kTraced says whether it was made with FST waveforms and with assertions,
// kPinLatency is the banks' own latency (the core's SRAM latency less the two pin registers of
// board_sram.v).
//
// A clock is two evaluations: inputs settle while it is low, then the rising edge. The core's clock
// rises with it only while the board asks for it, so a transfer to an idle board costs next to
// nothing.
#pragma once

#include <fmt/format.h>
#include <verilated.h>
#include <verilated_fst_c.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "host/board/clocked_board.h"
#include "host/board/pin_memory.h"
#include "host/board/sram.h"
#include "host/error.h"

namespace dynrt::host {

template <class V, unsigned kPinLatency, bool kTraced>
class VerilatedBoard final : public ClockedBoard {
 public:
  explicit VerilatedBoard(const std::string& trace = "", int seed = 0) : sram_(kPinLatency) {
    context_->traceEverOn(!trace.empty());
    if constexpr (kTraced) {
      context_->randReset(2);
      context_->randSeed(seed);
      context_->fatalOnError(false);  // $stop throws an exception
    }
    top_ = std::make_unique<V>(context_.get());
    if constexpr (kTraced) {
      if (!trace.empty()) open(trace);
    }
    top_->rst_ni = 0;
    idle();
  }
  ~VerilatedBoard() override {
    Verilated::threadContextp(context_.get());  // another board's may be gone
    top_->final();
    if (waves_) waves_->close();
  }

  void reset() override {
    top_->rst_ni = 0;
    idle();
    for (int i = 0; i < kResetClocks; ++i) clock();
    top_->rst_ni = 1;
    clock();
  }

  bool write(std::uint32_t address, std::span<const std::uint32_t> words) override {
    memory_.restart();
    top_->bus_valid_i = 1;
    top_->bus_write_i = 1;
    bool ok = true;
    for (std::size_t i = 0; ok && i < words.size(); ++i) {
      top_->bus_addr_i = address + static_cast<std::uint32_t>(4 * i);
      top_->bus_wdata_i = words[i];
      ok = transfer([] {});
    }
    idle();
    return ok;
  }

  bool read(std::uint32_t address, std::span<std::uint32_t> words) override {
    std::size_t arrived = 0;
    const auto collect = [&] {
      if (top_->bus_rvalid_o && arrived < words.size()) words[arrived++] = top_->bus_rdata_o;
    };
    top_->bus_valid_i = 1;
    top_->bus_write_i = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
      top_->bus_addr_i = address + static_cast<std::uint32_t>(4 * i);
      if (!transfer(collect)) break;
    }
    idle();
    for (int i = 0; arrived < words.size() && i < kPatience; ++i) {
      clock();
      collect();
    }
    return arrived == words.size();
  }

  bool run_until_interrupt(std::uint64_t limit) override {
    for (std::uint64_t i = 0; !top_->irq_o && i < limit; ++i) clock();
    return top_->irq_o;
  }

  void set_memory_timing(const MemoryTiming& timing) override { memory_.set_timing(timing); }

  void watch(VgaMonitor* monitor) override { monitor_ = monitor; }

  bool interrupt() const override { return top_->irq_o; }
  std::uint64_t clocks() const override { return clocks_; }
  std::optional<std::uint64_t> frame_writes() const override { return sram_.frame_writes(); }

 private:
  static constexpr int kResetClocks = 4;
  static constexpr int kPatience = 1000;  ///< clocks that a transfer may wait

  void open(const std::string& trace) {
    waves_ = std::make_unique<VerilatedFstC>();
    top_->trace(waves_.get(), 99);
    waves_->open(trace.c_str());
    if (!waves_->isOpen()) {
      refuse("{}: cannot write this file; name a file in a folder that can be written", trace);
    }
  }

  void idle() {
    top_->bus_valid_i = 0;
    top_->bus_write_i = 0;
    top_->bus_addr_i = 0;
    top_->bus_wdata_i = 0;
  }

  /// Clocks until the word on the bus is accepted.
  template <class AfterClock>
  bool transfer(AfterClock&& after) {
    for (int i = 0; i < kPatience; ++i) {
      const bool accepted = clock();
      after();
      if (accepted) return true;
    }
    return false;
  }

  /// One clock; true if the bus was ready in it.
  bool clock() {
    V& top = *top_;
    top.clk_i = 0;
    top.core_clk_i = 0;
    eval(0);
    const bool ready = top.bus_ready_o;
    const Sram::Data& data = access_sram(top);
    // Before the reset the pins may be anything.
    if (top.rst_ni) memory_.sample(top, sram_);
    top.clk_i = 1;
    top.core_clk_i = top.core_clk_en_o;
    eval(1);
    for (unsigned b = 0; b < kBanks; ++b) top.sram_rdata_i[b] = data[b];
    memory_.drive(top);
    ++clocks_;
    if (monitor_ != nullptr) {
      monitor_->sample(top.vga_clock_o, top.vga_hsync_o, top.vga_vsync_o, top.vga_visible_o,
                       top.vga_colour_o);
    }
    return ready;
  }

  const Sram::Data& access_sram(const V& top) {
    for (unsigned enable = top.sram_en_o; enable != 0; enable &= enable - 1) {
      const unsigned bank = static_cast<unsigned>(__builtin_ctz(enable));
      const unsigned bit = 20 * bank;
      std::uint64_t pair = top.sram_addr_o[bit / 32];
      if (bit / 32 + 1 < 4) pair |= std::uint64_t{top.sram_addr_o[bit / 32 + 1]} << 32;
      sram_.access(bank, (top.sram_we_o >> bank) & 1,
                   static_cast<std::uint32_t>(pair >> (bit % 32)), top.sram_wdata_o[bank]);
    }
    return sram_.advance();
  }

  void eval(unsigned half) {
    if constexpr (kTraced) Verilated::threadContextp(context_.get());  // which $stop speaks to
    top_->eval();
    if constexpr (kTraced) {
      if (waves_) waves_->dump(2 * clocks_ + half);
      if (context_->gotError()) {
        throw std::logic_error(fmt::format(
            "an assertion of the Verilog, printed above, fails in clock {} of the board", clocks_));
      }
    }
  }

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<V> top_;
  std::unique_ptr<VerilatedFstC> waves_;
  Sram sram_;
  MemoryAtPins<V> memory_;
  VgaMonitor* monitor_ = nullptr;
  std::uint64_t clocks_ = 0;
};

}  // namespace dynrt::host
