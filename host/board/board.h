// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board as the host sees it. RtlBoard runs the Verilog, ModelBoard the native C++ of the same
// units. They look the same outside this folder, except that the model counts clocks only with the
// units' schedules.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/board/bus.h"
#include "host/board/vga_monitor.h"
#include "host/error.h"
#include "host/format/core_info.h"
#include "units/frame.h"
#include "units/frame_watch.h"
#include "units/memory_timing.h"

namespace dynrt::host {

/// One of the core's counters, named as hls/counter_name.h names it.
struct Counter {
  std::string name;
  std::uint64_t value = 0;
  /// The same for every order of the packets; of one of several pipelines, the sum over all is.
  bool order_independent = false;
};

struct FrameRun {
  std::optional<std::uint64_t> cycles;  ///< of the core's clock; the model has none of its own
  bool scheduled = false;               ///< counted by the model with the units' schedules
  double seconds = 0;                   ///< of this computer's time, between start and interrupt
  bool missed_pixels = false;           ///< the board's display has waited for its memory
};

/// Called now and then with the number of pixels of the frame that are written.
using PixelProgress = std::function<void(std::uint64_t pixels)>;

/// Called while bytes go to a board or come from it, with their kind and their number so far and in
/// all.
using TransferProgress =
    std::function<void(std::string_view what, std::uint64_t done, std::uint64_t total)>;

/// The board never raised its interrupt.
struct TimeoutError : UserError {
  using UserError::UserError;
};

class Board {
 public:
  virtual ~Board() = default;
  /// The kind of board: "rtl", "model", "ulx3s" or "serial:DEVICE".
  const std::string& name() const { return name_; }
  /// The configuration and limits of its core, every key.
  const CoreInfo& core() const { return core_; }
  /// Tells whether display() can show a picture. The key scan_out is not enough: only Verilog has
  /// pins.
  virtual bool has_scan_out() const { return false; }

  /// Moves consecutive words of a bank; they must lie inside it. Not while a frame is rendered. A
  /// word of the scene's banks is format->bus_words() of them, the lowest bits first.
  virtual void write(unsigned bank, std::uint32_t address,
                     std::span<const std::uint32_t> words) = 0;
  virtual void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) = 0;
  /// Consecutive pixels of bank 3, from number `first` on, as 0x00BBGGRR, whatever the core's
  /// pixels are.
  virtual void read_pixels(std::uint32_t first, std::span<std::uint32_t> pixels);

  /// Sends the words that write() has buffered; only a board on a slow line buffers them.
  virtual void finish_writes() {}
  /// Called after the last read() of a frame's results. Throws UserError if the memory answered one
  /// of them with an error.
  virtual void finish_reads() {}
  /// Reports transfers to `progress`, if the line to the board is slow; an empty one ends that.
  virtual void report_transfers(TransferProgress /*progress*/) {}

  /// The name of the bus or line between host and board.
  virtual std::string_view bus() const { return "33 MHz PCI"; }
  /// The clock that a real or simulated board gives its core; none for an emulated one.
  virtual std::optional<double> clock_hz() const { return std::nullopt; }
  /// Whether the memory behind the core's port, if it has one, is emulated, so that it takes a
  /// timing.
  virtual bool emulates_memory() const { return true; }
  /// Sets the timing of the memory behind the core's port, if it has one, from the next frame on.
  virtual void set_memory_timing(const MemoryTiming& /*timing*/) {}
  /// Records into `watch`, if not null, what it asks for of the next frames; only a model can.
  virtual void observe(FrameWatch* /*watch*/) {}
  virtual void configure(const FrameConfig& frame) = 0;
  /// Throws UserError if the board refuses: the core has not the packets or the cache lines.
  virtual void start() = 0;
  /// Waits for the interrupt. After `timeout` clocks without an interrupt or another pixel it
  /// resets the board and throws a TimeoutError that names the state of each unit.
  virtual FrameRun wait(std::uint64_t timeout, const PixelProgress& progress) = 0;

  /// Shows the picture at word `base` of bank 3 in the middle of a VGA display of 640x480 and
  /// returns the image that a monitor sees at the pins. A pixel takes the given number of clocks,
  /// at least two. Throws UserError if the board has no scan-out or the picture does not fit.
  virtual DisplayFrame display(std::uint32_t base, unsigned width, unsigned height,
                               unsigned clocks_per_pixel);
  /// Throws UserError if display() would.
  void check_display(unsigned width, unsigned height) const;

  /// Of the last frame; none, if the configuration has no counters.
  virtual std::vector<Counter> counters() = 0;
  /// Since power-up.
  virtual BusTraffic traffic() const { return meter_.traffic(); }

 protected:
  Board(std::string name, CoreInfo core) : core_(std::move(core)), name_(std::move(name)) {}

  CoreInfo core_;
  BusMeter meter_;

 private:
  std::string name_;
};

}  // namespace dynrt::host
