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
  if (options.reflections.value_or(0) > 0) require_reflections(board->info(), "--reflections");
  frame_config(board->info(), options, {});
  return board;
}

SceneAddresses addresses_of(const FrameImage& frame, const Scene& scene) {
  return {.start_node = frame.start_node,
          .camera_matrix = frame.camera_matrix,
          .light_matrix = frame.light_matrix,
          .lights = static_cast<unsigned>(scene.lights.size()),
          .colour = frame.colour,
          .object = frame.first_instance};
}

Frame render_on(Board& board, const FrameOptions& options, const Prepared& prepared) {
  std::vector<MemoryRun> runs = prepared.objects.memory.runs();
  std::ranges::move(prepared.frame.memory.runs(), std::back_inserter(runs));
  std::vector<BankWords> memory;
  for (const MemoryRun& run : runs) memory.push_back({run.bank, run.address, run.words});

  Progress progress(fmt::format("rendering on board {}", board.info().name),
                    std::uint64_t{options.width} * options.height);
  return render(board, options, addresses_of(prepared.frame, prepared.scene), memory,
                [&](std::uint64_t pixels) { progress.update(pixels); });
}

std::string image_name(const std::string& out, const std::string& scene) {
  if (!out.empty()) return out;
  return std::filesystem::path(scene).stem().string() + ".png";
}

}  // namespace dynrt::host
