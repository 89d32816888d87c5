// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/board_frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <ranges>

#include "host/app/app_messages.h"
#include "host/app/light_flags.h"
#include "host/app/progress.h"
#include "host/error.h"
#include "host/ulx3s/ulx3s_board.h"

namespace dynrt::host {

namespace {

/// Throws UserError if no such board has that configuration.
void check_configuration(const BoardRequest& request) {
  const auto cores = linked_cores().first(request.board == kUlx3s ? 1 : linked_cores().size());
  const auto names = std::views::transform(cores, &LinkedCore::configuration);
  if (std::ranges::find(names, request.configuration) != names.end()) return;
  const std::string held = fmt::format("{}", fmt::join(names, " or "));
  refuse(messages::kHoldsAnother, request.board, held, request.configuration);
}

/// A board with a bitstream of its own has one configuration; the default stands for that.
std::unique_ptr<Board> open_ulx3s(const BoardRequest& request, const FrameOptions& options) {
  const bool any = request.configuration == kDefaultConfiguration;
  if (!any) check_configuration(request);
  if (!request.trace.empty()) refuse(messages::kNoWaveforms, request.board);
  const auto refuse_clocks = [&](const char* option, const std::optional<unsigned>& given) {
    if (given) refuse(messages::kMemoryExists, request.board, option);
  };
  refuse_clocks("--memory-latency", options.memory_latency);
  refuse_clocks("--row-clocks", options.row_clocks);
  auto board = make_ulx3s_board(request.board, any ? "" : request.configuration);
  if (request.board == kUlx3s) board->check_display(options.width, options.height);
  return board;
}

}  // namespace

std::unique_ptr<Board> open_board(const BoardRequest& request, const FrameOptions& options) {
  auto board = is_ulx3s(request.board) ? open_ulx3s(request, options)
                                       : make_board(configurations(), request);
  if (options.reflections.value_or(0) > 0) require_reflections(board->core(), "--reflections");
  frame_config(board->core(), options, {});
  return board;
}

Frame render_on(Board& board, const FrameOptions& options, const MemoryImage& image) {
  Progress progress(fmt::format("rendering on board {}", board.name()),
                    std::uint64_t{options.width} * options.height);
  return render(board, options, image, [&](std::uint64_t pixels) { progress.update(pixels); });
}

std::string image_name(const std::string& out, const std::string& scene) {
  if (!out.empty()) return out;
  return std::filesystem::path(scene).stem().string() + ".png";
}

}  // namespace dynrt::host
