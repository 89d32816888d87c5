// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/board_frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <ranges>
#include <utility>

#include "host/app/light_flags.h"
#include "host/board/display.h"
#include "host/error.h"
#include "host/ulx3s/board_at_link.h"

namespace dynrt::host {

namespace {

/// Throws UserError if no such board has that configuration.
void check_configuration(const BoardRequest& request) {
  const auto cores = linked_cores().first(request.board == kUlx3s ? 1 : linked_cores().size());
  const auto names = std::views::transform(cores, &LinkedCore::configuration);
  if (std::ranges::find(names, request.configuration) != names.end()) return;
  const std::string held = fmt::format("{}", fmt::join(names, " or "));
  refuse(
      "board {} holds configuration {}, not {}; name the one that it holds, or leave --config out",
      request.board, held, request.configuration);
}

/// A board with a bitstream of its own has one configuration, which need not be named.
std::unique_ptr<Board> open_at_link(const BoardRequest& request, const FrameOptions& options) {
  if (request.board == kSerial) {
    refuse("board {}: it names no device; write one after the colon, such as serial:/dev/ttyUSB0",
           request.board);
  }
  if (!request.configuration.empty()) check_configuration(request);
  if (!request.trace.empty()) {
    refuse("board {} writes no waveforms; --board rtl does", request.board);
  }
  if (!request.schedule.empty()) {
    refuse(
        "board {} counts its own clocks and takes no schedules; leave out --schedule, or take "
        "board model",
        request.board);
  }
  const auto refuse_clocks = [&](const char* option, const std::optional<unsigned>& given) {
    if (given) {
      refuse("board {}: its memory has fixed timing; leave out {}, or take board rtl or model",
             request.board, option);
    }
  };
  refuse_clocks("--memory-latency", options.memory_latency);
  refuse_clocks("--row-clocks", options.row_clocks);
  auto board = make_board_at_link(request.board, request.configuration);
  if (request.board == kUlx3s) check_display_size(board->core(), options.width, options.height);
  return board;
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
  return board;
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

std::string image_name(const std::string& out, const std::string& scene) {
  if (!out.empty()) return out;
  return std::filesystem::path(scene).stem().string() + ".png";
}

}  // namespace dynrt::host
