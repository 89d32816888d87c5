// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Renders one frame on any board: upload, start, interrupt, read-back.
#pragma once

#include <optional>

#include "host/board/board.h"
#include "host/layout/lay_out.h"
#include "host/render/frame.h"

namespace dynrt::host {

enum class RayOrder : std::uint8_t { kMorton, kScanline };

/// The user's options for a frame.
struct FrameOptions {
  unsigned width = 512;
  unsigned height = 384;
  std::optional<unsigned> packets{};  ///< in flight; all that the configuration has
  std::optional<unsigned> lines{};    ///< of each cache; all that the configuration has
  /// Of the memory behind the core's port, as MemoryTiming has them.
  std::optional<unsigned> memory_latency{}, row_clocks{};
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

/// The place of render()'s picture in bank 3.
inline constexpr std::uint32_t kFrameBase = 0;

/// Throws FrameRefused for a size of zero or beyond the framebuffer.
void check_size(unsigned width, unsigned height);

/// The frame's registers. Throws FrameRefused for options that the core lacks; lights that it has
/// no rays for do not shine.
FrameConfig frame_config(const CoreInfo& core, const FrameOptions& options,
                         const SceneAddresses& scene);

/// The clocks of the memory behind the core's port; nothing if it has none. Throws FrameRefused
/// likewise.
std::optional<MemoryTiming> memory_timing(const CoreInfo& core, const FrameOptions& options);

/// Renders; `memory` is uploaded first.
Frame render(Board& board, const FrameOptions& options, const SceneAddresses& scene,
             std::span<const MemoryRun> memory, const PixelProgress& progress = {});
/// Uploads the whole image and renders it; `options` has the image's size. Throws UserError for an
/// image that was laid out for another core.
Frame render(Board& board, const FrameOptions& options, const MemoryImage& image,
             const PixelProgress& progress = {});

}  // namespace dynrt::host
