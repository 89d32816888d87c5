// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#include "host/board/board.h"
#include "host/error.h"

namespace dynrt::host {

/// The board's own rule for a start (rtl/board/dynrt_registers.vh): whether the core has as many
/// packets and cache lines as the frame asks for.
inline bool can_render(const CoreInfo& core, const FrameConfig& frame) {
  const std::uint64_t packets = frame.packets.to_u64();
  const std::uint64_t lines = frame.line_mask.to_u64() + 1;
  return packets >= 1 && packets <= core.packets && std::has_single_bit(lines) &&
         lines <= core.lines;
}

/// The board has refused to start the frame.
[[noreturn]] inline void refuse_start(const Board& board, const FrameConfig& frame) {
  refuse(
      "board {}: it refused to start a frame with {} packets and {} cache lines; its core takes 1 "
      "to {} packets, and a power of two of at most {} lines",
      board.name(), frame.packets.to_u64(), frame.line_mask.to_u64() + 1, board.core().packets,
      board.core().lines);
}

}  // namespace dynrt::host
