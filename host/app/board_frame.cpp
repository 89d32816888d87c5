// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/board_frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ranges>
#include <stdexcept>
#include <utility>

#include "host/app/text.h"
#include "host/board/display.h"
#include "host/error.h"
#include "host/picture/write_image.h"
#include "host/ulx3s/board_at_link.h"

namespace dynrt::host {

namespace {

/// A board with a bitstream of its own has one configuration, which need not be named.
std::unique_ptr<Board> open_at_link(const BoardRequest& request, const FrameOptions& options) {
  const bool ulx3s = request.board == kUlx3s;
  const auto cores = linked_cores().first(ulx3s ? 1 : linked_cores().size());
  const auto names = std::views::transform(cores, &LinkedCore::configuration);
  if (request.board == kSerial) {
    refuse("board {}: it names no device; write one after the colon, such as serial:/dev/ttyUSB0",
           request.board);
  }
  if (!request.configuration.empty() &&
      std::ranges::find(names, request.configuration) == names.end()) {
    refuse(
        "board {} holds configuration {}, not {}; name the one that it holds, or leave --config "
        "out",
        request.board, fmt::format("{}", fmt::join(names, " or ")), request.configuration);
  }
  if (!request.trace.empty()) {
    refuse("board {} writes no waveforms; --board rtl does", request.board);
  }
  if (!request.schedule.empty()) {
    refuse(
        "board {} counts its own clocks and takes no schedules; leave out --schedule, or take "
        "board model",
        request.board);
  }
  if (options.memory_latency || options.row_clocks) {
    refuse("board {}: its memory has fixed timing; leave out {}, or take board rtl or model",
           request.board, options.memory_latency ? "--memory-latency" : "--row-clocks");
  }
  auto board = make_board_at_link(request.board, request.configuration);
  if (ulx3s) check_display_size(board->core(), options.width, options.height);
  return board;
}

unsigned clocks_per_pixel(double clock_mhz) {
  const double clocks = std::round(clock_mhz / k640x480.pixel_mhz);
  return static_cast<unsigned>(
      std::clamp<double>(clocks, Display::kLeastClocks, Display::kMostClocks));
}

std::size_t count_different(const DisplayFrame& display, const Frame& frame) {
  const DisplayMode& m = display.mode;
  const unsigned left = (m.hdisplay - frame.width) / 2;
  const unsigned top = (m.vdisplay - frame.height) / 2;
  std::size_t differ = 0;
  for (unsigned y = 0; y < frame.height; ++y) {
    for (unsigned x = 0; x < frame.width; ++x) {
      const std::uint32_t pixel = frame.pixels[std::size_t{y} * frame.width + x] & 0xffffff;
      differ += display.pixels[std::size_t{top + y} * m.hdisplay + left + x] != pixel;
    }
  }
  return differ;
}

}  // namespace

std::unique_ptr<Board> open_board(const BoardRequest& request, const FrameOptions& options) {
  const auto open = [&] {
    if (is_at_link(request.board)) return open_at_link(request, options);
    BoardRequest named = request;
    if (named.configuration.empty()) named.configuration = kDefaultConfiguration;
    return make_board(configurations(), named);
  };
  auto board = open();
  if (options.reflections.value_or(0) > 0) require_reflections(board->core(), "--reflections");
  frame_config(board->core(), options, {});
  if (request.shows) board->check_display(options.width, options.height);
  return board;
}

OnBoard on_board(const BoardRequest& request, const FrameOptions& options, SceneFile& scene,
                 const TreeOptions& trees) {
  auto board = open_board(request, options);
  Prepared prepared = prepare(scene, &board->core(), trees);
  return {std::move(board), std::move(prepared)};
}

OnBoard prepare_on(const SpecialiseFlags& flags, const ChosenCore& core, BoardRequest request,
                   const FrameOptions& options, SceneFile& scene, const TreeOptions& trees) {
  request.configuration = core.configuration;
  try {
    return on_board(request, options, scene, trees);
  } catch (const Exceeded& over) {
    flags.refuse_unless_general(over);
  }
  request.configuration = core.general;
  return on_board(request, options, scene, trees);
}

BoardProgress::BoardProgress(Board& board, std::string what, std::uint64_t pixels)
    : board_(board), progress_(std::move(what), pixels) {
  board_.report_transfers([this](std::string_view part, std::uint64_t done, std::uint64_t total) {
    progress_.update(part, done, total);
  });
}

PixelProgress BoardProgress::pixels() {
  return [this](std::uint64_t done) { progress_.update(done); };
}

Frame render_on(Board& board, const FrameOptions& options, const MemoryImage& image) {
  BoardProgress progress(board, fmt::format("rendering on board {}", board.name()),
                         std::uint64_t{options.width} * options.height);
  return render(board, options, image, progress.pixels());
}

Shown show(Board& board, const Frame& frame, double clock_mhz, const std::string& file) {
  const unsigned clocks = clocks_per_pixel(clock_mhz);
  DisplayFrame display = board.display(kFrameBase, frame.width, frame.height, clocks);
  if (!display.fault.empty() || display.mode != k640x480.mode) {
    throw std::logic_error("the signal is not VGA of 640x480: " + display.fault);
  }
  Shown shown;
  shown.image = file;
  shown.mode = display.mode;
  shown.clocks_per_pixel = display.pixel_time;
  shown.displays_per_second =
      clock_mhz * 1e6 / clocks / (double{1} * display.mode.htotal * display.mode.vtotal);
  shown.differ = count_different(display, frame);

  Frame image;
  image.width = display.mode.hdisplay;
  image.height = display.mode.vdisplay;
  image.pixels = std::move(display.pixels);
  write_image(file, image);
  return shown;
}

std::string Shown::text() const {
  return fmt::format(
      "scan-out    {}, {}x{}, {} clocks a pixel, {:.2f} displays per second; {} pixels differ from "
      "the frame's\n",
      image, mode.hdisplay, mode.vdisplay, clocks_per_pixel, displays_per_second, grouped(differ));
}

nlohmann::ordered_json Shown::json() const {
  return {{"image", image},
          {"width", mode.hdisplay},
          {"height", mode.vdisplay},
          {"clocks_per_pixel", clocks_per_pixel},
          {"displays_per_second", displays_per_second},
          {"pixels_different", differ}};
}

std::string image_name(const std::string& out, const std::string& scene) {
  if (!out.empty()) return out;
  return std::filesystem::path(scene).stem().string() + ".png";
}

}  // namespace dynrt::host
