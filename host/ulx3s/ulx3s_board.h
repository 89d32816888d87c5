// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The ULX3S as a board of the renderer: a real one at a serial device, or a simulated one, whose
// picture is what a monitor sees at its DVI pins.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "host/board/rtl_board.h"
#include "host/ulx3s/linked_board.h"
#include "host/ulx3s/simulated_ulx3s.h"

namespace dynrt::host {

/// The configuration that its bitstream holds.
inline constexpr const char* kUlx3sConfiguration = "fast_port";
inline constexpr std::string_view kUlx3s = "ulx3s";
inline constexpr std::string_view kSerial = "serial:";  ///< and the path of a device

/// Whether this is the name of such a board.
bool is_ulx3s(std::string_view board);

class Ulx3sBoard final : public RtlBoard {
 public:
  /// `simulated`, if not null, is the line that `linked` uses.
  Ulx3sBoard(std::string name, std::unique_ptr<LinkedBoard> linked, SimulatedUlx3s* simulated);

  bool has_scan_out() const override { return true; }
  void finish_writes() override { linked_.send_memory(); }
  std::string_view bus() const override;
  std::optional<double> clock_hz() const override { return linked_.clock_hz(); }
  bool emulates_memory() const override { return false; }
  BusTraffic traffic() const override { return linked_.traffic(); }
  void configure(const FrameConfig& frame) override;
  void read_pixels(std::uint32_t first, std::span<std::uint32_t> pixels) override;

 private:
  /// The picture as it is shown.
  void read_display(std::span<std::uint32_t> pixels);

  /// `linked` is what the base owns.
  Ulx3sBoard(std::string name, LinkedBoard& linked, std::unique_ptr<LinkedBoard>&& owned,
             SimulatedUlx3s* simulated);

  LinkedBoard& linked_;
  SimulatedUlx3s* simulated_;
  FrameConfig shown_;
  bool shows_ = false;  ///< a picture that fits the display
};

/// A board of one of the names above. Throws UserError if there is none.
std::unique_ptr<Board> make_ulx3s_board(const std::string& board);

}  // namespace dynrt::host
