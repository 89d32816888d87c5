// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A board for the renderer at the end of a link: a real one at a serial device, such as a ULX3S or
// an Arty (rtl/arty), or a simulated ULX3S, whose picture is the one that a monitor sees at its DVI
// pins.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/board/display_mode.h"
#include "host/board/rtl_board.h"
#include "host/ulx3s/linked_board.h"
#include "host/ulx3s/simulated_ulx3s.h"

namespace dynrt::host {

/// The core of a bitstream whose host is at a serial line.
struct LinkedCore {
  std::string_view configuration;
  CoreInfo (*info)();
  std::string_view (*json)();  ///< as its join describes it: dynrt_core.json of its Verilog
};
/// The first is that of the ULX3S.
std::span<const LinkedCore> linked_cores();
/// That of the board at the end of a link, which must be `configuration` if that is not empty.
/// Throws UserError if it is none of these.
const LinkedCore& linked_core(const BoardLink& link, const std::string& board,
                              const std::string& configuration = "");

inline constexpr std::string_view kUlx3s = "ulx3s";
inline constexpr std::string_view kSerial = "serial:";  ///< and the path of a device

/// Whether this is the name of such a board.
bool is_at_link(std::string_view board);

class BoardAtLink final : public RtlBoard {
 public:
  /// `simulated`, if not null, is the line that `linked` uses.
  BoardAtLink(std::string name, const LinkedCore& core, std::unique_ptr<LinkedBoard> linked,
              SimulatedUlx3s* simulated);

  /// read_pixels() already gives the picture of its display.
  bool has_scan_out() const override { return false; }
  void finish_writes() override { linked_.send_memory(); }
  void report_transfers(TransferProgress progress) override {
    linked_.report_transfers(std::move(progress));
  }
  std::string_view bus() const override;
  std::optional<double> clock_hz() const override { return linked_.clock_hz(); }
  bool emulates_memory() const override { return false; }
  BusTraffic traffic() const override { return linked_.traffic(); }
  void configure(const FrameConfig& frame) override;
  void read_pixels(std::uint32_t first, std::span<std::uint32_t> pixels) override;

 private:
  /// The picture as it is shown.
  void read_display(std::span<std::uint32_t> pixels);

  /// `linked` is the object that the base owns.
  BoardAtLink(std::string name, const LinkedCore& core, LinkedBoard& linked,
              std::unique_ptr<LinkedBoard>&& owned, SimulatedUlx3s* simulated);

  LinkedBoard& linked_;
  SimulatedUlx3s* simulated_;
  const DisplayMode* mode_;  ///< of its display; null if it has none
  FrameConfig shown_;
  bool shows_ = false;  ///< a picture that fits the display
};

/// A board of one of the names above, which must have this configuration; an empty name accepts any
/// configuration. Throws UserError if there is no such board.
std::unique_ptr<Board> make_board_at_link(const std::string& board,
                                          const std::string& configuration = "");

}  // namespace dynrt::host
