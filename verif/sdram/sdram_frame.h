// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A frame of a native core with an SDRAM behind its port: its settings and its results.
#pragma once

#include <memory>
#include <string>

#include "core/scenes.h"
#include "host/board/native_core.h"
#include "host/format/core_info.h"
#include "host/render/render.h"
#include "sdram/sdram_memory.h"
#include "sdram/sdram_stages.h"

namespace dynrt::verif {

struct SdramFrame {
  host::Frame frame;
  SdramUse use;
  unsigned refresh_clocks = 0;  ///< that one refresh keeps the chip from moving words, at least
  std::string report;  ///< of all that the data sheet forbids, and empty if nothing was found
};

/// Where the clocks of a frame come from.
struct SdramSchedules {
  std::string core;        ///< the folder with those of its units
  std::string controller;  ///< the file of the SDRAM's controller
};

/// Bytes a second that a display of 640x480 reads at 60 Hz.
template <class C>
inline constexpr double kDisplayed = 640. * 480 * 60 * C::kPixelBits / 8;

/// A frame of the core C by its schedules; without `memory` its own emulated one answers.
template <class C>
host::Frame native_frame(host::CoreInfo info, const std::string& scene,
                         const host::FrameOptions& options, const std::string& schedules,
                         const typename CoreModel<C>::MakeMemory& memory = {}) {
  auto core = std::make_unique<host::NativeCoreOf<C>>();
  if (memory) core->model().set_memory(memory);
  host::ModelBoard board(std::move(info), std::move(core), schedules);
  const host::MemoryImage image =
      host::laid_out(scene, options.width, options.height, board.core());
  return host::render(board, options, image);
}

/// The same with an SDRAM at the clock of S.
template <class C, class S>
SdramFrame sdram_frame(host::CoreInfo info, const std::string& scene,
                       const host::FrameOptions& options, const SdramSystem& system,
                       const SdramSchedules& schedules) {
  SdramPart part = kAnySdram;
  part.pause = 2 * SdramMemory<C, S>::kPauseTurns * S::kClockPicoseconds;
  SdramBench<kBeatBytes<C>> bench(SdramChip(part, S::kClockPicoseconds));
  using Timing = SdramTiming<S>;
  SdramFrame result;
  result.refresh_clocks = 2 * (2 + Timing::kPrechargeToActivate + Timing::kRefreshToActivate);
  const unsigned stages = stages_of(schedules.controller);
  const auto memory = [&](Core<C>& core, Banks<C>& banks) -> std::unique_ptr<hls::Device> {
    return std::make_unique<SdramMemory<C, S>>(core.memory.read, core.memory.beat,
                                               core.memory.write, banks, system, stages, bench,
                                               result.use);
  };
  result.frame = native_frame<C>(std::move(info), scene, options, schedules.core, memory);
  result.report = bench.report();
  return result;
}

}  // namespace dynrt::verif
