// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/board.h"
#include "units/pixel.h"

namespace dynrt::host {

void Board::read_pixels(std::uint32_t first, std::span<std::uint32_t> pixels) {
  if (core_.pixel_bytes() == WordPixel::kBytes) {
    read(kFrameBank, first, pixels);
    return;
  }
  // A word holds two, the first one lower.
  const std::uint32_t first_word = first / 2;
  std::vector<std::uint32_t> words((first + pixels.size() + 1) / 2 - first_word);
  read(kFrameBank, first_word, words);
  for (std::uint32_t& pixel : pixels) {
    const std::uint32_t word = words[first / 2 - first_word];
    const auto bits = uint<16>::from(first % 2 == 0 ? word : word >> 16);
    pixel = static_cast<std::uint32_t>(HalfPixel::colour(bits).to_u64());
    ++first;
  }
}

}  // namespace dynrt::host
