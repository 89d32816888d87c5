// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A Verilated top with a bus to its memory and one to its registers, as a board that RtlBoard runs,
// so that host/render renders with it. The host reaches the memory at its own end: what RtlBoard
// writes to the SRAM window goes there, and only registers go over the bus. V is the Verilated
// class, Memory and Host the other ends of its buses. The Verilog's assertions, and with them the
// rules of the buses, are checked in every clock (std::logic_error).
#pragma once

#include <fmt/format.h>
#include <verilated.h>

#include <memory>
#include <optional>
#include <stdexcept>

#include "bus/bus_memory.h"
#include "host/board/clocked_board.h"
#include "host/board/window.h"

namespace dynrt::host::bus {

template <class V, template <class> class Memory, template <class> class Host>
class BusBoard final : public ClockedBoard {
 public:
  BusBoard(const Temper& temper, int seed) : memory_(temper, seed), host_(seed) {
    context_->randReset(2);
    context_->randSeed(seed);
    context_->fatalOnError(false);  // $stop throws an exception
    top_ = std::make_unique<V>(context_.get());
    memory_.drive(*top_);
    host_.drive(*top_);
  }
  ~BusBoard() override {
    Verilated::threadContextp(context_.get());  // another board's may be gone
    top_->final();
  }

  Memory<V>& memory() { return memory_; }

  void reset() override {
    top_->rst_ni = 0;
    for (int i = 0; i < 4; ++i) clock();
    top_->rst_ni = 1;
    clock();
  }
  bool write(std::uint32_t address, std::span<const std::uint32_t> words) override {
    for (const std::uint32_t word : words) {
      if (window::holds(address)) {
        memory_.sram().access(window::bank(address), true, window::word(address), word);
      } else if (!write_register(address, word)) {
        return false;
      }
      address += 4;
    }
    return true;
  }
  bool read(std::uint32_t address, std::span<std::uint32_t> words) override {
    for (std::uint32_t& word : words) {
      if (window::holds(address)) {
        word = memory_.sram().word(window::bank(address), window::word(address));
      } else {
        const std::optional<RegisterAnswer> answer = read_register(address);
        if (!answer || answer->error) return false;
        word = answer->data;
      }
      address += 4;
    }
    return true;
  }
  bool run_until_interrupt(std::uint64_t limit) override {
    for (std::uint64_t i = 0; !top_->irq_o && i < limit; ++i) clock();
    return top_->irq_o;
  }
  bool interrupt() const override { return top_->irq_o; }
  std::uint64_t clocks() const override { return clocks_; }
  void watch(VgaMonitor* /*monitor*/) override {}
  std::optional<std::uint64_t> frame_writes() const override {
    return memory_.sram().frame_writes();
  }

  /// Nothing if no answer comes.
  std::optional<RegisterAnswer> read_register(std::uint32_t address) {
    host_.begin_read(address);
    return settles() ? std::optional(host_.read()) : std::nullopt;
  }
  std::optional<RegisterAnswer> try_write(std::uint32_t address, std::uint32_t word,
                                          unsigned strobe) {
    host_.begin_write(address, word, strobe);
    return settles() ? std::optional(host_.written()) : std::nullopt;
  }
  void clock() {
    eval(0);
    // Before the reset the pins may be anything.
    if (top_->rst_ni) {
      memory_.sample(*top_);
      host_.sample(*top_);
    }
    eval(1);
    memory_.drive(*top_);
    host_.drive(*top_);
    ++clocks_;
  }
  Host<V>& host() { return host_; }
  bool settles() {
    for (int i = 0; !host_.idle() && i < kPatience; ++i) clock();
    return host_.idle();
  }

 private:
  static constexpr int kPatience = 1000;  ///< clocks that an access may wait

  bool write_register(std::uint32_t address, std::uint32_t word) {
    const std::optional<RegisterAnswer> answer = try_write(address, word, 15);
    return answer && !answer->error;
  }
  void eval(unsigned level) {
    Verilated::threadContextp(context_.get());  // which $stop speaks to
    set(top_->clk_i, level);
    top_->eval();
    if (context_->gotError()) {
      throw std::logic_error(fmt::format("an assertion does not hold in clock {}", clocks_));
    }
  }

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<V> top_;
  Memory<V> memory_;
  Host<V> host_;
  std::uint64_t clocks_ = 0;
};

}  // namespace dynrt::host::bus
