// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A FrameConfig as the board's FRAME registers, one word per field.
#pragma once

#include <array>
#include <cstdint>

#include "units/frame.h"

namespace dynrt::host {

inline constexpr unsigned kFrameWords = hls::bit_width_of<FrameConfig>() / 32;

inline std::array<std::uint32_t, kFrameWords> frame_words(const FrameConfig& frame) {
  std::array<std::uint32_t, kFrameWords> words{};
  hls::for_each_leaf(frame, [&](const hls::uint<32>& field, unsigned offset) {
    words[offset / 32] = static_cast<std::uint32_t>(field.to_u64());
  });
  return words;
}

/// A register's value from a host number.
inline hls::uint<32> to_word(std::uint32_t value) { return hls::uint<32>::from(value); }

}  // namespace dynrt::host
