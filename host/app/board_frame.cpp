// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/board_frame.h"

#include <fmt/format.h>

#include <filesystem>

#include "host/app/progress.h"

namespace dynrt::host {

std::unique_ptr<Board> open_board(const BoardRequest& request, const FrameOptions& options) {
  auto board = make_board(configurations(), request);
  frame_config(board->info(), options, {});
  return board;
}

Frame render_on(Board& board, const FrameOptions& options, const Prepared& prepared) {
  std::vector<MemoryRun> runs = prepared.objects.memory.runs();
  std::ranges::move(prepared.frame.memory.runs(), std::back_inserter(runs));
  std::vector<BankWords> memory;
  for (const MemoryRun& run : runs) memory.push_back({run.bank, run.address, run.words});

  Progress progress(fmt::format("rendering on board {}", board.info().name),
                    std::uint64_t{options.width} * options.height);
  const SceneAddresses scene{.start_node = prepared.frame.start_node,
                             .camera_matrix = prepared.frame.camera_matrix,
                             .light_matrix = prepared.frame.light_matrix,
                             .lights = static_cast<unsigned>(prepared.scene.lights.size())};
  return render(board, options, scene, memory,
                [&](std::uint64_t pixels) { progress.update(pixels); });
}

std::string image_name(const std::string& out, const std::string& scene) {
  if (!out.empty()) return out;
  return std::filesystem::path(scene).stem().string() + ".png";
}

}  // namespace dynrt::host
