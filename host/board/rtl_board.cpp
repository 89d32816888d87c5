// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/rtl_board.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "host/board/check_range.h"
#include "host/board/check_start.h"
#include "host/board/registers.h"
#include "host/board/standstill.h"
#include "host/board/window.h"
#include "host/error.h"
#include "host/format/frame_words.h"
#include "units/scan_out.h"

namespace dynrt::host {

namespace reg = registers;

namespace {

constexpr char kRefused[] =
    "board {}: it refused an access during the frame; the SRAM and the frame's registers belong to "
    "the core until the interrupt";

constexpr char kBusHangs[] =
    "board {}: the bus waits for ever at address {:#x}; the Verilog behind it is broken";

static_assert(kMaxFrameWords <= 1u << reg::kFrameWordBits,
              "FrameConfig has more fields than the board has room for FRAME registers");

constexpr std::uint64_t kClocksPerReport = 10'000;
constexpr std::string_view kFreedPackets = "free_packet.tokens";  ///< a counter
constexpr std::uint32_t kNoMemoryThere = 3;                       ///< in MEMORY_ERROR
constexpr int kResetReads = 100;  ///< reads of STATUS that outlast the core's reset by far

}  // namespace

RtlBoard::RtlBoard(CoreInfo core, std::unique_ptr<ClockedBoard> clocked,
                   std::vector<Counter> counters, std::string kind)
    : Board(std::move(kind), std::move(core)),
      clocked_(std::move(clocked)),
      counters_(std::move(counters)) {
  const auto freed = std::ranges::find(counters_, kFreedPackets, &Counter::name);
  if (freed != counters_.end()) {
    freed_packets_ = static_cast<std::uint32_t>(freed - counters_.begin());
  }
  clocked_->reset();
  const std::uint32_t id = read_register(reg::kRegId);
  const std::uint32_t version = read_register(reg::kRegVersion);
  if (id != reg::kIdValue || version != reg::kVersionValue) {
    refuse(
        "board {}: its registers give the id {:#x} and the version {:#x}, but the host expects "
        "{:#x} and {:#x}; rebuild the Verilog and the host together",
        name(), id, version, reg::kIdValue, reg::kVersionValue);
  }
  const std::uint32_t words = read_register(reg::kRegFrameWords);
  const std::size_t expected = core_.frame_words({}).size();
  if (words != expected) {
    refuse(
        "board {}: it has {} frame registers, but the host writes {}; rebuild the Verilog and the "
        "host together",
        name(), words, expected);
  }
  const std::uint32_t scan_words = read_register(reg::kRegScanWords);
  if (scan_words != 0 && scan_words != kScanWords) {
    refuse(
        "board {}: it has {} registers for its scan-out, but the host writes {}; rebuild the "
        "Verilog and the host together",
        name(), scan_words, kScanWords);
  }
  core_.scan_out = scan_words != 0;
  const std::uint32_t limits = read_register(reg::kRegLimits);
  core_.packets = limits & 0xffff;
  core_.lines = limits >> 16;
  settle();
  // What another program has left is not of this one's frames.
  write_register(reg::kRegMemoryError, 1u << reg::kMemoryErrorSeen);
  write_register(reg::kRegIrqEnable, 1);
}

void RtlBoard::settle() {
  if (settles()) return;
  write_register(reg::kRegControl, 1u << reg::kControlReset);
  if (!settles()) {
    refuse(
        "board {}: its core stays busy after a reset; press the board's reset, or load its "
        "bitstream again",
        name());
  }
}

bool RtlBoard::settles() {
  for (int i = 0; i < kResetReads; ++i) {
    if (!(read_register(reg::kRegStatus) >> reg::kStatusBusy & 1)) return true;
  }
  return false;
}

void RtlBoard::write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) {
  check_range(*this, bank, address, words.size());
  burst_write(window::address(bank, address), words);
}

void RtlBoard::read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) {
  check_range(*this, bank, address, words.size());
  burst_read(window::address(bank, address), words);
}

void RtlBoard::finish_reads() {
  if (read_register(reg::kRegStatus) >> reg::kStatusMemoryError & 1) refuse_memory_error();
}

void RtlBoard::configure(const FrameConfig& frame) {
  frame_ = frame;
  burst_write(reg::kRegFrame, core_.frame_words(frame));
}

void RtlBoard::start() {
  frame_writes_at_start_ = clocked_->frame_writes().value_or(0);
  write_register(reg::kRegControl, 1u << reg::kControlStart);
  const std::uint32_t status = read_register(reg::kRegStatus);
  if (!(status >> reg::kStatusRefused & 1)) return;
  if (status >> reg::kStatusBusy & 1) throw std::logic_error(fmt::format(kRefused, name()));
  refuse_start(*this, frame_);
}

FrameRun RtlBoard::wait(std::uint64_t timeout, const PixelProgress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const std::uint64_t pixels = frame_.width.to_u64() * frame_.height.to_u64();
  std::uint64_t written = 0;
  std::uint64_t left = timeout;
  while (!clocked_->interrupt() && left > 0) {
    const std::uint64_t before = clocked_->clocks();
    clocked_->run_until_interrupt(std::min(left, kClocksPerReport));
    const std::uint64_t passed = clocked_->clocks() - before;
    if (passed == 0 && !clocked_->interrupt()) {
      refuse(
          "board {}: its core stopped in the middle of a frame, after {} clocks; press the board's "
          "reset, or load its bitstream again",
          name(), before);
    }
    // A core that writes pixels for ever is stuck as well.
    const std::uint64_t now = std::min(pixels_written(), pixels);
    left = now > written ? timeout : left - std::min(left, passed);
    written = now;
    if (progress) progress(written);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (!clocked_->interrupt()) give_up(timeout, written);
  write_register(reg::kRegIrqPending, 1);
  const std::uint32_t status = read_register(reg::kRegStatus);
  if (status >> reg::kStatusRefused & 1) {
    throw std::logic_error(fmt::format(kRefused, name()));
  }
  if (status >> reg::kStatusMemoryError & 1) refuse_memory_error();
  std::array<std::uint32_t, 2> cycles{};
  burst_read(reg::kRegCyclesLow, cycles);
  return {.cycles = cycles[0] | std::uint64_t{cycles[1]} << 32,
          .seconds = seconds.count(),
          .missed_pixels = (status >> reg::kStatusDisplayMissed & 1) != 0};
}

std::uint64_t RtlBoard::pixels_written() {
  if (const auto halves = clocked_->frame_writes()) {
    return 2 * (*halves - frame_writes_at_start_) / core_.pixel_bytes();
  }
  if (!freed_packets_) return 0;
  // At first all packets are freed.
  write_register(reg::kRegCounterAddress, *freed_packets_);
  const std::uint64_t freed = read_register(reg::kRegCounterData);
  return (freed - std::min<std::uint64_t>(freed, core_.packets)) * core_.packet_rays;
}

void RtlBoard::refuse_memory_error() {
  const std::uint32_t error = read_register(reg::kRegMemoryError);
  const std::uint32_t byte = read_register(reg::kRegMemoryErrorAddress);
  write_register(reg::kRegMemoryError, 1u << reg::kMemoryErrorSeen);
  const bool is_write = (error >> reg::kMemoryErrorWrite & 1) != 0;
  const bool nothing_there = (error >> reg::kMemoryErrorResponse & 3) == kNoMemoryThere;
  refuse(
      "board {}: {} answered a {} of byte {:#x} of the core's memory, so the frame may be wrong; "
      "look at what stands behind the core's port at that address",
      name(), nothing_there ? "no memory, but an error of the bus," : "an error of the memory",
      is_write ? "write" : "read", byte);
}

void RtlBoard::give_up(std::uint64_t timeout, std::uint64_t pixels) {
  const std::uint32_t status = read_register(reg::kRegStatus);
  const std::vector<Counter> before = counters();  // reading them takes some hundred clocks
  const std::string state = where_units_stand(before, counters());
  write_register(reg::kRegControl, 1u << reg::kControlReset);
  settle();
  throw TimeoutError(
      fmt::format("board {}: no interrupt and no pixel for {} clocks (a longer timeout allows "
                  "more); {} pixels are written, the status is {:#x}, the units: {}",
                  name(), timeout, pixels, status, state));
}

std::vector<Counter> RtlBoard::counters() {
  std::vector<Counter> counters = counters_;
  for (std::uint32_t i = 0; i < counters.size(); ++i) {
    write_register(reg::kRegCounterAddress, i);
    counters[i].value = read_register(reg::kRegCounterData);
  }
  return counters;
}

std::uint32_t RtlBoard::read_register(std::uint32_t address) {
  std::uint32_t value = 0;
  burst_read(address, {&value, 1});
  return value;
}

void RtlBoard::write_register(std::uint32_t address, std::uint32_t value) {
  burst_write(address, {&value, 1});
}

void RtlBoard::burst_write(std::uint32_t address, std::span<const std::uint32_t> words) {
  meter_.write(words.size());
  if (!clocked_->write(address, words)) {
    refuse(kBusHangs, name(), address);
  }
}

void RtlBoard::burst_read(std::uint32_t address, std::span<std::uint32_t> words) {
  meter_.read(words.size());
  if (!clocked_->read(address, words)) {
    refuse(kBusHangs, name(), address);
  }
}

}  // namespace dynrt::host
