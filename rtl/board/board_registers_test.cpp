// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board's registers alone, with a transfer on the bus in every clock: order, refusals, the
// start and the reset of a frame. The other ports of the Verilog are the test's.
#include <deque>
#include <map>
#include <random>

#include "Vboard_registers.h"
#include "Vboard_registers_slow.h"
#include "host/board/registers.h"
#include "rtl/lib/lib_test.h"

namespace dynrt::rtl {
namespace {

namespace reg = host::registers;

constexpr std::uint32_t kFrameWord = reg::kRegFrame + 4 * 2;
constexpr std::uint32_t kPackets = reg::kRegFrame;
constexpr std::uint32_t kLineMask = reg::kRegFrame + 4;
constexpr std::uint32_t kWindow = 1u << reg::kWindowBit;
constexpr std::uint32_t kStart = 1u << reg::kControlStart;
constexpr std::uint32_t kReset = 1u << reg::kControlReset;

struct Fast {
  using Verilated = Vboard_registers;
  static constexpr unsigned kLatency = 3;
};
struct Slow {
  using Verilated = Vboard_registers_slow;
  static constexpr unsigned kLatency = 8;
};

template <class T>
class BoardRegisters : public testing::Test {
 protected:
  BoardRegisters() { reset(v_); }
  void write(std::uint32_t address, std::uint32_t value) { transfer(true, address, value); }
  /// The read is answered while the bus goes on.
  void read(std::uint32_t address, std::uint32_t expected) {
    transfer(false, address, 0);
    answers_.push_back({clock_ - 1 + T::kLatency + 2, expected});
  }
  void idle(unsigned clocks) {
    v_.bus_valid_i = 0;
    for (unsigned i = 0; i < clocks; ++i) step();
  }
  /// Waits until all answers have come.
  void all_answered() {
    idle(T::kLatency + 4);
    EXPECT_TRUE(answers_.empty());
  }
  /// One clock; true if the bus was ready in it. A frame that starts makes the board busy.
  bool step() {
    v_.busy_i = busy_;
    v_.counter_data_i = counters_.size() == 3 ? counters_.front() : 0;
    settle(v_);
    const bool ready = v_.bus_ready_o;
    if (counters_.size() == 3) counters_.pop_front();
    counters_.push_back(1000u + v_.counter_addr_o);
    if (v_.irq_o) ++interrupts_;
    if (v_.start_o) busy_ = true;
    if (v_.start_o || v_.reset_o) ++begun_;
    if (v_.bus_rvalid_o) {
      if (answers_.empty() || answers_.front().clock != clock_) {
        ADD_FAILURE() << "an answer in clock " << clock_;
      } else {
        EXPECT_EQ(v_.bus_rdata_o, answers_.front().word) << "in clock " << clock_;
        answers_.pop_front();
      }
    }
    clock(v_);
    ++clock_;
    return ready;
  }
  void transfer(bool is_write, std::uint32_t address, std::uint32_t value) {
    v_.bus_valid_i = 1;
    v_.bus_write_i = is_write;
    v_.bus_addr_i = address;
    v_.bus_wdata_i = value;
    while (!step()) {
    }
  }
  void good_frame() {
    write(kPackets, 4);
    write(kLineMask, 15);
  }

  struct Answer {
    std::uint64_t clock;
    std::uint32_t word;
  };
  VerilatedContext context_;
  typename T::Verilated v_{&context_};
  std::deque<Answer> answers_;
  std::deque<std::uint32_t> counters_;  ///< on their way, which takes three clocks
  std::uint64_t clock_ = 0;
  bool busy_ = false;
  unsigned interrupts_ = 0;
  unsigned begun_ = 0;
};
using Latencies = testing::Types<Fast, Slow>;
TYPED_TEST_SUITE(BoardRegisters, Latencies);

TYPED_TEST(BoardRegisters, AReadSeesEveryWriteBeforeItAndNoneBehindIt) {
  std::mt19937 random(1);
  std::map<std::uint32_t, std::uint32_t> held = {
      {kFrameWord, 0}, {kFrameWord + 4, 0}, {reg::kRegIrqEnable, 0}, {reg::kRegCounterAddress, 0}};
  for (unsigned i = 0; i < 5000; ++i) {
    const auto& [address, value] = *std::next(held.begin(), random() % held.size());
    const bool counter = address == reg::kRegCounterAddress;
    if (random() % 2 == 0) {
      const std::uint32_t mask = address == reg::kRegIrqEnable ? 1 : counter ? 255 : ~0u;
      held[address] = static_cast<std::uint32_t>(random()) & mask;
      this->write(address, held[address]);
    } else if (counter) {
      this->read(reg::kRegCounterData, 1000 + value);
    } else {
      this->read(address, value);
    }
  }
  this->all_answered();
}

TYPED_TEST(BoardRegisters, AStartTakesTheFrameThatWasWrittenJustBefore) {
  this->good_frame();
  this->write(kPackets, 65);
  this->write(reg::kRegControl, kStart);
  this->read(reg::kRegStatus, 1u << reg::kStatusRefused);
  this->write(kPackets, 4);
  this->write(kLineMask, 3);
  this->write(kLineMask, 5);
  this->write(reg::kRegControl, kStart);
  this->read(reg::kRegStatus, 1u << reg::kStatusRefused);
  EXPECT_EQ(this->begun_, 0u);
  this->write(kLineMask, 7);
  this->write(reg::kRegControl, kStart);
  this->read(reg::kRegStatus, 1u << reg::kStatusBusy);
  this->all_answered();
  EXPECT_EQ(this->begun_, 1u);
  EXPECT_EQ(this->v_.last_packet_o, 3u);
  EXPECT_EQ(this->v_.last_line_o, 7u);
}

TYPED_TEST(BoardRegisters, WhatComesBehindAStartIsRefused) {
  for (const std::uint32_t address : {kWindow, kFrameWord}) {
    this->good_frame();
    this->write(kFrameWord, 11);
    this->write(reg::kRegControl, kStart);
    this->write(address, 22);
    this->read(kFrameWord, 11);
    this->read(reg::kRegStatus, 1u << reg::kStatusBusy | 1u << reg::kStatusRefused);
    this->all_answered();
    this->busy_ = false;
  }
}

TYPED_TEST(BoardRegisters, NoInterruptFollowsAReset) {
  this->write(reg::kRegIrqEnable, 1);
  for (unsigned ends = 0; ends < 2; ++ends) {
    SCOPED_TRACE(ends);
    this->good_frame();
    this->write(reg::kRegControl, kStart);
    this->idle(10);
    // The frame ends in the clock in which the bus takes the reset, or a clock later. From the
    // third on the sequencer knows of the reset.
    this->v_.bus_valid_i = 1;
    this->v_.bus_write_i = 1;
    this->v_.bus_addr_i = reg::kRegControl;
    this->v_.bus_wdata_i = kReset;
    this->interrupts_ = 0;
    for (unsigned t = 0; t < 10; ++t) {
      this->v_.done_i = t == ends;
      this->step();
      this->v_.bus_valid_i = 0;
    }
    EXPECT_EQ(this->interrupts_, 0u);
    this->busy_ = false;
    this->read(reg::kRegIrqPending, 0);
    this->all_answered();
  }
}

TYPED_TEST(BoardRegisters, AFrameThatEndsInterrupts) {
  this->write(reg::kRegIrqEnable, 1);
  this->v_.done_i = 1;
  this->idle(1);
  this->v_.done_i = 0;
  this->idle(2);
  EXPECT_GT(this->interrupts_, 0u);
  this->read(reg::kRegStatus, 1u << reg::kStatusDone);
  this->all_answered();
}

TYPED_TEST(BoardRegisters, TheStatusTellsOfMissedPixels) {
  for (const bool missed : {true, false}) {
    this->v_.scan_missed_i = missed;
    this->read(reg::kRegStatus, std::uint32_t{missed} << reg::kStatusDisplayMissed);
    this->all_answered();
  }
}

}  // namespace
}  // namespace dynrt::rtl
