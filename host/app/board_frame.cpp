// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/board_frame.h"

#include <fmt/format.h>

#include <filesystem>

#include "host/app/light_flags.h"
#include "host/app/progress.h"

namespace dynrt::host {

std::unique_ptr<Board> open_board(const BoardRequest& request, const FrameOptions& options) {
  auto board = make_board(configurations(), request);
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
