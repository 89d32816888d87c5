// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board whose core is the Verilog, run by Verilator. Everything goes through its registers and
// its SRAM window, as over a real bus (rtl/board/dynrt_registers.vh).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/board/board.h"
#include "host/board/clocked_board.h"

namespace dynrt::host {

class RtlBoard : public Board {
 public:
  /// The board's registers replace the limits in `core`. `counters` are in the order of their
  /// addresses; their values are ignored.
  RtlBoard(CoreInfo core, std::unique_ptr<ClockedBoard> clocked, std::vector<Counter> counters,
           std::string kind = "rtl");

  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override;
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override;
  void finish_reads() override;
  void set_memory_timing(const MemoryTiming& timing) override {
    clocked_->set_memory_timing(timing);
  }
  void configure(const FrameConfig& frame) override;
  void start() override;
  FrameRun wait(std::uint64_t timeout, const PixelProgress& progress) override;
  bool has_scan_out() const override { return core().scan_out; }
  DisplayFrame display(std::uint32_t base, unsigned width, unsigned height,
                       unsigned clocks_per_pixel) override;
  std::vector<Counter> counters() override;

  /// For the display (display.h): shows the VGA pins to the monitor; clocks the board, at most
  /// until an interrupt.
  void watch(VgaMonitor* monitor) { clocked_->watch(monitor); }
  void idle(std::uint64_t clocks) { clocked_->run_until_interrupt(clocks); }

  /// Registers, for the display and for tests of the board itself.
  std::uint32_t read_register(std::uint32_t address);
  void write_register(std::uint32_t address, std::uint32_t value);

 private:
  void burst_write(std::uint32_t address, std::span<const std::uint32_t> words);
  void burst_read(std::uint32_t address, std::span<std::uint32_t> words);
  /// Waits for the end of the core's reset, a few clocks; resets a core that works.
  void settle();
  bool settles();
  /// Of the frame under way.
  std::uint64_t pixels_written();
  /// Clears the error.
  [[noreturn]] void refuse_memory_error();
  [[noreturn]] void give_up(std::uint64_t timeout, std::uint64_t pixels);

  std::unique_ptr<ClockedBoard> clocked_;
  std::vector<Counter> counters_;
  FrameConfig frame_;  ///< the one that the FRAME registers hold
  std::uint64_t frame_writes_at_start_ = 0;
  std::optional<std::uint32_t> freed_packets_;  ///< the address of their counter
};

}  // namespace dynrt::host
