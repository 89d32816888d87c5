// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/ulx3s/board_at_link.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <ranges>
#include <thread>
#include <utility>

#include "configs/fast_port.h"
#include "configs/fast_ulx3s.h"
#include "host/board/configurations.h"
#include "host/board/display.h"
#include "host/board/registers.h"
#include "host/error.h"
#include "host/link/serial_device.h"

namespace dynrt::host {

namespace reg = registers;

std::string_view fast_ulx3s_core_json();
std::string_view fast_port_core_json();

namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr milliseconds kPoll{1};  ///< of a real board's state
constexpr microseconds kSimulatedPoll{500};
constexpr milliseconds kDisplayStep{2};
constexpr unsigned kDisplaySteps = 17;  ///< of two frames
constexpr unsigned kMostDisplaySteps = 50;

constexpr LinkedCore kLinkedCores[] = {
    {"fast_ulx3s", [] { return core_info_of_listed<config::fast_ulx3s>("fast_ulx3s"); },
     fast_ulx3s_core_json},
    {"fast_port", [] { return core_info_of_listed<config::fast_port>("fast_port"); },
     fast_port_core_json},
};

}  // namespace

std::span<const LinkedCore> linked_cores() { return kLinkedCores; }

const LinkedCore& linked_core(const BoardLink& link, const std::string& board,
                              const std::string& configuration) {
  if (!configuration.empty()) link.expect_configuration(configuration);
  const std::string& held = link.board().configuration;
  const auto found = std::ranges::find(kLinkedCores, held, &LinkedCore::configuration);
  if (found == std::end(kLinkedCores)) {
    const auto known = std::views::transform(kLinkedCores, &LinkedCore::configuration);
    refuse(
        "board {}: its bitstream has configuration {}, which this program does not know at a "
        "serial line; load a bitstream that has {}",
        board, held, fmt::format("{}", fmt::join(known, " or ")));
  }
  return *found;
}

bool is_at_link(std::string_view board) { return board == kUlx3s || board.starts_with(kSerial); }

BoardAtLink::BoardAtLink(std::string name, const LinkedCore& core,
                         std::unique_ptr<LinkedBoard> linked, SimulatedUlx3s* simulated)
    : BoardAtLink(std::move(name), core, *linked, std::move(linked), simulated) {}

BoardAtLink::BoardAtLink(std::string name, const LinkedCore& core, LinkedBoard& linked,
                         std::unique_ptr<LinkedBoard>&& owned, SimulatedUlx3s* simulated)
    : RtlBoard(core.info(), std::move(owned), counters_of(core.json()), std::move(name)),
      linked_(linked),
      simulated_(simulated),
      mode_(mode_of_link(linked.pixel_mhz())) {}

std::string_view BoardAtLink::bus() const {
  static_assert(kLinkBaud == 3'000'000);
  return "a serial line of 3 Mbaud";
}

void BoardAtLink::configure(const FrameConfig& frame) {
  RtlBoard::configure(frame);
  const auto number = [](const hls::uint<32>& field) {
    return static_cast<unsigned>(field.to_u64());
  };
  const unsigned width = number(frame.width);
  const unsigned height = number(frame.height);
  if (shows_ && frame.width == shown_.width && frame.height == shown_.height) {
    write_register(reg::kRegScan, number(frame.frame_base));
  } else {
    if (mode_ != nullptr) write_register(reg::kRegScanClocks, 0);
    shows_ = mode_ != nullptr && core().pitch(width) == width && width <= mode_->hdisplay &&
             height <= mode_->vdisplay;
    if (shows_) {
      write_scan(*this, scan_config(*mode_, number(frame.frame_base), width, height));
      write_register(reg::kRegScanClocks, 1);
    }
  }
  shown_ = frame;
}

void BoardAtLink::read_pixels(std::uint32_t first, std::span<std::uint32_t> pixels) {
  const bool is_picture = first == shown_.frame_base.to_u64() &&
                          pixels.size() == shown_.width.to_u64() * shown_.height.to_u64();
  if (simulated_ != nullptr && shows_ && is_picture) {
    read_display(pixels);
  } else {
    RtlBoard::read_pixels(first, pixels);
  }
}

void BoardAtLink::read_display(std::span<std::uint32_t> pixels) {
  linked_.count_read(pixels.size() * core().pixel_bytes());
  simulated_->take_frames();
  const LinkProgress progress = linked_.progress_of("waiting for its display", kDisplaySteps);
  // The frame under way may have begun before the picture was complete.
  std::vector<DisplayFrame> frames;
  for (unsigned step = 0; frames.size() < 2; ++step) {
    if (step == kMostDisplaySteps) {
      refuse(
          "the monitor at the DVI pins of the simulated ULX3S has seen no frame within 100 "
          "milliseconds");
    }
    if (progress) progress(std::min(step, kDisplaySteps));
    simulated_->run(kDisplayStep);
    std::ranges::move(simulated_->take_frames(), std::back_inserter(frames));
  }
  const DisplayFrame& frame = frames.back();
  if (!frame.fault.empty()) {
    refuse("the monitor at the DVI pins of the simulated ULX3S cannot show the signal: {}",
           frame.fault);
  }
  if (frame.mode != *mode_) {
    refuse(
        "the monitor at the DVI pins of the simulated ULX3S sees a mode of {}x{} pixels, not {}x{}",
        frame.mode.hdisplay, frame.mode.vdisplay, mode_->hdisplay, mode_->vdisplay);
  }
  const std::size_t width = shown_.width.to_u64();
  const std::size_t height = shown_.height.to_u64();
  const std::size_t left = (mode_->hdisplay - width) / 2;
  const std::size_t top = (mode_->vdisplay - height) / 2;
  for (std::size_t y = 0; y < height; ++y) {
    const std::size_t row = (top + y) * mode_->hdisplay + left;
    std::ranges::copy_n(frame.pixels.begin() + static_cast<std::ptrdiff_t>(row),
                        static_cast<std::ptrdiff_t>(width),
                        pixels.begin() + static_cast<std::ptrdiff_t>(y * width));
  }
}

std::unique_ptr<Board> make_board_at_link(const std::string& board,
                                          const std::string& configuration) {
  SimulatedUlx3s* ulx3s = nullptr;
  std::unique_ptr<ByteStream> line;
  LinkedBoard::Pause pause = [] { std::this_thread::sleep_for(kPoll); };
  if (board.starts_with(kSerial)) {
    line = std::make_unique<SerialDevice>(board.substr(kSerial.size()));
  } else {
    auto simulated = make_simulated_ulx3s();
    ulx3s = simulated.get();
    line = std::move(simulated);
    pause = [ulx3s] { ulx3s->run(kSimulatedPoll); };
  }
  auto link = std::make_unique<BoardLink>(std::move(line));
  const LinkedCore& core = linked_core(*link, board, configuration);
  return std::make_unique<BoardAtLink>(
      board, core, std::make_unique<LinkedBoard>(std::move(link), ulx3s, std::move(pause)), ulx3s);
}

}  // namespace dynrt::host
