// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/display.h"

#include <fmt/format.h>

#include <exception>
#include <stdexcept>

#include "host/board/registers.h"
#include "host/error.h"
#include "host/format/frame_words.h"

namespace dynrt::host {

namespace reg = registers;

ScanConfig scan_config(const DisplayMode& m, std::uint32_t base, unsigned width, unsigned height) {
  const unsigned left = (m.hdisplay - width) / 2;
  const unsigned top = (m.vdisplay - height) / 2;
  const unsigned positive = (m.positive_hsync ? 1u : 0u) | (m.positive_vsync ? 2u : 0u);
  ScanConfig c;
  c.base = to_word(base);
  c.width = to_word(width);
  c.height = to_word(height);
  c.left = to_word(left);
  c.top = to_word(top);
  c.hdisplay = to_word(m.hdisplay);
  c.hsync_start = to_word(m.hsync_start);
  c.hsync_end = to_word(m.hsync_end);
  c.htotal = to_word(m.htotal);
  c.vdisplay = to_word(m.vdisplay);
  c.vsync_start = to_word(m.vsync_start);
  c.vsync_end = to_word(m.vsync_end);
  c.vtotal = to_word(m.vtotal);
  c.positive_syncs = to_word(positive);
  return c;
}

void write_scan(RtlBoard& board, const ScanConfig& scan) {
  hls::for_each_leaf(scan, [&](const hls::uint<32>& field, unsigned offset) {
    board.write_register(reg::kRegScan + offset / 8, static_cast<std::uint32_t>(field.to_u64()));
  });
}

namespace {

void check_scan_out(const Board& board) {
  if (!board.has_scan_out()) {
    refuse(
        "board {} of configuration {} has no scan-out; take board rtl and a configuration with the "
        "key scan_out, such as thesis",
        board.name(), board.core().name);
  }
}

void check_size(const DisplayMode& mode, unsigned width, unsigned height) {
  if (width > mode.hdisplay || height > mode.vdisplay) {
    refuse("a picture of {}x{} does not fit the display of {}x{}; render a smaller one", width,
           height, mode.hdisplay, mode.vdisplay);
  }
}

}  // namespace

void check_display_size(const CoreInfo& core, unsigned width, unsigned height) {
  check_size(k640x480.mode, width, height);
  const unsigned pitch = core.pitch(width);
  if (pitch != width) {
    refuse(
        "a display shows rows that follow each other, and those of configuration {} begin {} "
        "pixels apart where {} are rendered; render a picture whose width is a multiple of {}",
        core.name, pitch, width, kPitchStep);
  }
}

Display::Display(RtlBoard& board, const DisplayMode& mode, unsigned clocks_per_pixel,
                 std::uint32_t base, unsigned width, unsigned height)
    : board_(board),
      monitor_(mode.positive_hsync, mode.positive_vsync),
      clocks_(std::uint64_t{mode.htotal} * mode.vtotal * clocks_per_pixel) {
  check_scan_out(board_);
  check_size(mode, width, height);
  if (clocks_per_pixel < kLeastClocks || clocks_per_pixel > kMostClocks) {
    throw std::logic_error(
        fmt::format("the scan-out cannot take {} clocks for each pixel", clocks_per_pixel));
  }
  write_scan(board_, scan_config(mode, base, width, height));
  board_.watch(&monitor_);
  board_.write_register(reg::kRegScanClocks, clocks_per_pixel);
}

Display::~Display() {
  board_.watch(nullptr);
  try {
    board_.write_register(reg::kRegScanClocks, 0);
  } catch (const std::exception&) {
    // Errors of the board were reported where they occurred.
  }
}

void Display::show(std::uint32_t base) { board_.write_register(reg::kRegScan, base); }

std::uint32_t Display::shown() { return board_.read_register(reg::kRegScanShown); }

const DisplayFrame& Display::wait(unsigned count) {
  const std::size_t enough = frames().size() + count;
  for (unsigned i = 0; frames().size() < enough; ++i) {
    // The first whole one begins in the second display, after at most two.
    if (i > 8 * (count + 2)) throw std::logic_error("the scan-out gives no pixels");
    board_.idle(clocks_ / 4);
  }
  return frames()[enough - 1];
}

void Board::check_display(unsigned width, unsigned height) const {
  check_scan_out(*this);
  check_display_size(core_, width, height);
}

DisplayFrame Board::display(std::uint32_t /*base*/, unsigned width, unsigned height,
                            unsigned /*clocks_per_pixel*/) {
  check_display(width, height);
  throw std::logic_error("a board with a scan-out cannot show a picture");
}

DisplayFrame RtlBoard::display(std::uint32_t base, unsigned width, unsigned height,
                               unsigned clocks_per_pixel) {
  Display display(*this, k640x480.mode, clocks_per_pixel, base, width, height);
  return display.wait(1);
}

}  // namespace dynrt::host
