// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A Verilated board with only the operations of its bus. VerilatedBoard implements it for every
// Verilated class, RtlBoard uses it. The calls are coarse, so that the loop over clocks is compiled
// together with the Verilated class.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "host/board/vga_monitor.h"
#include "units/memory_timing.h"

namespace dynrt::host {

class ClockedBoard {
 public:
  virtual ~ClockedBoard() = default;
  /// Holds the reset for some clocks.
  virtual void reset() = 0;
  /// Writes or reads consecutive words; false if the board keeps the bus waiting for ever.
  virtual bool write(std::uint32_t address, std::span<const std::uint32_t> words) = 0;
  virtual bool read(std::uint32_t address, std::span<std::uint32_t> words) = 0;
  /// Clocks the board until the interrupt line is high, at most `limit` times or a few more; true
  /// if it is. clocks() stays as it was if the clock of a board that exists stands still.
  virtual bool run_until_interrupt(std::uint64_t limit) = 0;

  /// Of the memory behind the core's port, if it has one.
  virtual void set_memory_timing(const MemoryTiming& /*timing*/) {}

  virtual bool interrupt() const = 0;
  virtual std::uint64_t clocks() const = 0;  ///< since power-up
  /// Shows the VGA pins of every clock to this monitor from now on; null: to none.
  virtual void watch(VgaMonitor* monitor) = 0;
  /// Halves of words written to bank 3 since power-up; none if nobody sees them.
  virtual std::optional<std::uint64_t> frame_writes() const = 0;
};

/// Makes a board. The second kind is slower and shows more: it writes waveforms to the FST file
/// `trace` if it is named, checks the Verilog's assertions (std::logic_error if one fails), and
/// fills everything that the Verilog has not written with random bits from `seed`.
using MakeBoard = std::unique_ptr<ClockedBoard> (*)();
using MakeTracedBoard = std::unique_ptr<ClockedBoard> (*)(const std::string& trace, int seed);

}  // namespace dynrt::host
