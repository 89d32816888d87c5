// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A picture that another object owns: this room knows neither boards nor frames.
#pragma once

#include <cstdint>
#include <span>

namespace dynrt::host {

struct PictureView {
  unsigned width = 0;
  unsigned height = 0;
  std::span<const std::uint32_t> pixels;  ///< 0x00BBGGRR, row by row from the top

  PictureView(unsigned width, unsigned height, std::span<const std::uint32_t> pixels)
      : width(width), height(height), pixels(pixels) {}

  /// Of a Frame and of all else that has these three.
  template <typename Frame>
    requires requires(const Frame& frame) { std::span<const std::uint32_t>(frame.pixels); }
  PictureView(const Frame& frame) : PictureView(frame.width, frame.height, frame.pixels) {}
};

}  // namespace dynrt::host
