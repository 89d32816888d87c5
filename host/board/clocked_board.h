// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A Verilated board, reduced to what its bus can do; VerilatedBoard implements it for every
// Verilated class, RtlBoard uses it. The calls are coarse, so that the loop over clocks is compiled
// together with the Verilated class.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "host/board/vga_monitor.h"

namespace dynrt::host {

class ClockedBoard {
 public:
  virtual ~ClockedBoard() = default;
  /// Holds the reset for some clocks.
  virtual void reset() = 0;
  /// Writes or reads consecutive words; false if the board keeps the bus waiting for ever.
  virtual bool write(std::uint32_t address, std::span<const std::uint32_t> words) = 0;
  virtual bool read(std::uint32_t address, std::span<std::uint32_t> words) = 0;
  /// Clocks the board until the interrupt line is high, at most `limit` times; true if it is.
  virtual bool run_until_interrupt(std::uint64_t limit) = 0;

  virtual bool interrupt() const = 0;
  virtual std::uint64_t clocks() const = 0;  ///< since power-up
  /// From now on shows the monitor every clock's VGA pins; null: nobody.
  virtual void watch(VgaMonitor* monitor) = 0;
  virtual std::uint64_t frame_writes() const = 0;  ///< words written to bank 3 since power-up
};

/// Makes one. That of the second kind is slower and shows more: it writes its waveforms to the FST
/// file `trace` if one is named, it checks the Verilog's assertions (std::logic_error when one
/// fails), and whatever the Verilog has not written is random from `seed`.
using MakeBoard = std::unique_ptr<ClockedBoard> (*)();
using MakeTracedBoard = std::unique_ptr<ClockedBoard> (*)(const std::string& trace, int seed);

}  // namespace dynrt::host
