// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/cost_meter.h"

#include <fmt/format.h>

#include <stdexcept>

#include "host/app/board_frame.h"
#include "host/render/figures.h"

namespace dynrt::host {

CostMeter::CostMeter(SceneFile& file, const AnalysedFrames& frames) : file_(file) {
  frame_.reflections = frames.reflections;
  frame_.uncompressed = frames.uncompressed;
  frame_.memory = frames.memory;
}

FrameCosts CostMeter::count(const LoweredCore& core, unsigned packets, unsigned lines) {
  const std::tuple asked(core.configuration, packets, lines);
  if (const auto known = known_.find(asked); known != known_.end()) return known->second;
  FrameOptions options = frame_.options(file_.arguments());
  options.packets = packets;
  options.lines = lines;
  // A new board, as the caches of another hold what its last frame left there.
  const auto board = open_board({"model", core.configuration, "", core.verilog}, options);
  if (configuration_ != core.configuration) {
    prepared_ = prepare(file_, &board->core());
    configuration_ = core.configuration;
  }
  BoardProgress progress(
      *board, fmt::format("measuring a frame with {} packets and {} lines", packets, lines),
      std::uint64_t{options.width} * options.height);
  const Frame frame = render(*board, options, *prepared_, progress.pixels());
  if (!frame.run.cycles) throw std::logic_error("the model counted no clocks by " + core.verilog);
  return known_[asked] = {*frame.run.cycles, bytes_per_ray(frame)};
}

}  // namespace dynrt::host
