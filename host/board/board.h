// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board as the host sees it. RtlBoard runs the Verilog, ModelBoard the native C++ of the same
// units; nothing outside this folder can tell them apart, except that the model has no clock but
// what the units' schedules say.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/board/frame_words.h"
#include "host/board/vga_monitor.h"
#include "host/error.h"
#include "host/format/memory_format_of.h"
#include "units/frame.h"
#include "units/options.h"

namespace dynrt::host {

struct BoardInfo {
  std::string name;            ///< "rtl" or "model"
  std::string configuration;   ///< name of the core's configuration, e.g. "thesis"
  unsigned packets = 0;        ///< packets that can be in flight, at most
  unsigned cache_lines = 0;    ///< lines of each cache, at most
  unsigned stack_depth = 0;    ///< entries of a packet's stack in an object's tree
  unsigned lights = 0;         ///< passes of light rays from a packet's hits, at most
  bool clips_to_cube = false;  ///< it takes an object's box for the cube from -1 to 1
  unsigned reflections = 0;    ///< bounces of a ray, at most
  Crossing crossing = Crossing::kNone;
  bool counters = true;   ///< it counts what its units do
  bool scan_out = false;  ///< it can show a picture on a VGA display; only the RTL has pins
  TriangleMatrix triangle_matrix = TriangleMatrix::kNormalConsistent;
  Primitives primitives{.triangle = true};
  TriangleTest triangle_test = TriangleTest::kUnitTriangle;
  Divider divider = Divider::kDigitRecurrence;
  const MemoryFormat* format = &kShippedFormat;  ///< its numbers, and how its memory holds them
  unsigned top_stack_depth = 31;         ///< entries of a packet's stack in the top-level tree
  unsigned address_bits = kAddressBits;  ///< of the nodes and list entries that it can reach
  unsigned matrix_bits = kMatrixBits;    ///< of the matrices
  unsigned levels = 2;       ///< of trees: 1, of one object that lies in the world as it is
  bool one_colour = false;   ///< it has one colour for all surfaces
  bool uncompressed = true;  ///< it can transform every ray's origin
  /// The words of its FRAME registers.
  std::vector<std::uint32_t> (*frame_words)(const FrameConfig&) = frame_words_of<ShippedRegisters>;
  std::string made_for = {};  ///< the scene that it was specialised for, or empty
  std::shared_ptr<const BoardInfo> made_from = {};  ///< the core that it was specialised from
};

/// One of the core's counters, named unit.what, e.g. "traversal.transactions".
struct Counter {
  std::string name;
  std::uint64_t value = 0;
  bool order_independent = false;  ///< the same whatever the order in which packets are served
};

/// What went over the bus, and what it would have taken on 33 MHz, 32-bit PCI.
struct BusTraffic {
  std::uint64_t transactions = 0;
  std::uint64_t bytes_written = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t bus_clocks = 0;
  friend bool operator==(const BusTraffic&, const BusTraffic&) = default;
  /// What came since `before`.
  friend BusTraffic operator-(const BusTraffic& now, const BusTraffic& before) {
    return {now.transactions - before.transactions, now.bytes_written - before.bytes_written,
            now.bytes_read - before.bytes_read, now.bus_clocks - before.bus_clocks};
  }
};

struct FrameRun {
  std::optional<std::uint64_t> cycles;  ///< of the core's clock; the model has none of its own
  bool scheduled = false;               ///< they are what the model makes of the units' schedules
  double seconds = 0;                   ///< of this computer's time, between start and interrupt
};

/// Told now and then how many pixels of the frame are written.
using PixelProgress = std::function<void(std::uint64_t pixels)>;

/// The board never raised its interrupt.
struct TimeoutError : UserError {
  using UserError::UserError;
};

class Board {
 public:
  virtual ~Board() = default;
  virtual const BoardInfo& info() const = 0;

  /// Moves consecutive words of a bank; they must lie inside it. Not while a frame is rendered. A
  /// word of the scene's banks is format->bus_words() of them, the lowest bits first.
  virtual void write(unsigned bank, std::uint32_t address,
                     std::span<const std::uint32_t> words) = 0;
  virtual void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) = 0;

  virtual void configure(const FrameConfig& frame) = 0;
  virtual void start() = 0;
  /// Waits for the interrupt; after `timeout` clocks without it or another pixel throws a
  /// TimeoutError that tells where the units stand, and resets the board.
  virtual FrameRun wait(std::uint64_t timeout, const PixelProgress& progress) = 0;

  /// Shows the picture at word `base` of bank 3 in the middle of a VGA display of 640x480 and gives
  /// what a monitor makes of the pins; a pixel takes that many clocks, at least two. Throws
  /// UserError if the board has no scan-out or the picture does not fit.
  virtual VgaFrame display(std::uint32_t base, unsigned width, unsigned height,
                           unsigned clocks_per_pixel);
  /// Throws UserError if display() would.
  void check_display(unsigned width, unsigned height) const;

  /// Of the last frame; none, if the configuration has no counters.
  virtual std::vector<Counter> counters() = 0;
  /// Since power-up.
  virtual BusTraffic traffic() const = 0;
};

}  // namespace dynrt::host
