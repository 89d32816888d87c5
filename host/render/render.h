// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One frame on a board: upload, start, interrupt, read-back. The board is whichever it is.
#pragma once

#include <optional>

#include "host/board/board.h"
#include "host/render/frame.h"

namespace dynrt::host {

/// Consecutive words of one bank.
struct BankWords {
  unsigned bank = 0;
  std::uint32_t address = 0;
  std::span<const std::uint32_t> words;
};

enum class RayOrder : std::uint8_t { kMorton, kScanline };

/// What the user chooses about a frame.
struct FrameOptions {
  unsigned width = 512;
  unsigned height = 384;
  std::optional<unsigned> packets{};  ///< in flight; all that the configuration has
  std::optional<unsigned> lines{};    ///< of each cache; all that the configuration has
  RayOrder order = RayOrder::kMorton;
  std::optional<unsigned> reflections{};  ///< bounces; all that the configuration has
  bool uncompressed = false;              ///< transform every ray's origin, not one for the packet
  std::uint32_t background = 0;           ///< 0x00BBGGRR
  std::uint64_t timeout = 0;              ///< clocks
  bool hits = true;                       ///< write hit records and read them back
  unsigned buffer = 0;                    ///< of the kFrameBuffers that take turns
};

/// The framebuffer's bank holds two images: one is shown while the next is made in the other.
inline constexpr unsigned kFrameBuffers = 2;

/// Where the scene lies in the board's memory.
struct SceneAddresses {
  std::uint32_t start_node = 0;
  std::uint32_t camera_matrix = 0;
  std::uint32_t light_matrix = 0;  ///< of light 0
  unsigned lights = 0;
  std::uint32_t colour = 0;  ///< of all surfaces, if they have one
  std::uint32_t object = 0;  ///< number of the first instance
};

/// Where render() has the picture in bank 3.
inline constexpr std::uint32_t kFrameBase = 0;

/// Throws UserError for a size of zero or beyond the framebuffer.
void check_size(unsigned width, unsigned height);

/// The board's registers for a frame. Throws UserError for what the board's configuration lacks;
/// of the scene's lights those that it has no rays for do not shine.
FrameConfig frame_config(const BoardInfo& board, const FrameOptions& options,
                         const SceneAddresses& scene);

/// Renders; `memory` is uploaded first.
Frame render(Board& board, const FrameOptions& options, const SceneAddresses& scene,
             std::span<const BankWords> memory, const PixelProgress& progress);

}  // namespace dynrt::host
