// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A frame as the board's FRAME registers, one word for each that the core's configuration has.
#pragma once

#include <cstdint>
#include <vector>

#include "configs/shipped.h"
#include "units/frame.h"

namespace dynrt::host {

/// All that there are in any configuration.
inline constexpr unsigned kMaxFrameWords = hls::bit_width_of<FrameConfig>() / 32;

template <class C>
std::vector<std::uint32_t> frame_words_of(const FrameConfig& frame) {
  std::vector<std::uint32_t> words;
  const FrameRegisters<C> registers = registers_of<C>(frame);
  hls::for_each_leaf(registers, [&](const hls::uint<32>& field, unsigned) {
    words.push_back(static_cast<std::uint32_t>(field.to_u64()));
  });
  return words;
}

/// Of the first configuration of hls/configs/configs.json.
inline constexpr unsigned kShippedFrameWords =
    hls::bit_width_of<FrameRegisters<config::shipped>>() / 32;

/// A register's value from a host number.
inline hls::uint<32> to_word(std::uint32_t value) { return hls::uint<32>::from(value); }

}  // namespace dynrt::host
