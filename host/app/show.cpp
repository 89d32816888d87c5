// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/show.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host/app/text.h"
#include "host/board/display.h"
#include "host/picture/write_image.h"
#include "host/render/render.h"

namespace dynrt::host {

namespace {

unsigned clocks_per_pixel(double clock_mhz) {
  const double clocks = std::round(clock_mhz / k640x480.pixel_mhz);
  return static_cast<unsigned>(
      std::clamp<double>(clocks, Display::kLeastClocks, Display::kMostClocks));
}

std::size_t count_different(const DisplayFrame& display, const Frame& frame) {
  const DisplayMode& m = display.mode;
  const unsigned left = (m.hdisplay - frame.width) / 2;
  const unsigned top = (m.vdisplay - frame.height) / 2;
  std::size_t differ = 0;
  for (unsigned y = 0; y < frame.height; ++y) {
    for (unsigned x = 0; x < frame.width; ++x) {
      const std::uint32_t pixel = frame.pixels[std::size_t{y} * frame.width + x] & 0xffffff;
      differ += display.pixels[std::size_t{top + y} * m.hdisplay + left + x] != pixel;
    }
  }
  return differ;
}

}  // namespace

Shown show(Board& board, const Frame& frame, double clock_mhz, const std::string& file) {
  const unsigned clocks = clocks_per_pixel(clock_mhz);
  DisplayFrame display = board.display(kFrameBase, frame.width, frame.height, clocks);
  if (!display.fault.empty() || display.mode != k640x480.mode) {
    throw std::logic_error("the signal is not VGA of 640x480: " + display.fault);
  }
  Shown shown;
  shown.image = file;
  shown.mode = display.mode;
  shown.clocks_per_pixel = display.pixel_time;
  shown.displays_per_second =
      clock_mhz * 1e6 / clocks / (double{1} * display.mode.htotal * display.mode.vtotal);
  shown.differ = count_different(display, frame);

  Frame image;
  image.width = display.mode.hdisplay;
  image.height = display.mode.vdisplay;
  image.pixels = std::move(display.pixels);
  write_image(file, image);
  return shown;
}

std::string Shown::text() const {
  return fmt::format(
      "scan-out    {}, {}x{}, {} clocks a pixel, {:.2f} displays per second; {} pixels differ from "
      "the frame's\n",
      image, mode.hdisplay, mode.vdisplay, clocks_per_pixel, displays_per_second, grouped(differ));
}

nlohmann::ordered_json Shown::json() const {
  return {{"image", image},
          {"width", mode.hdisplay},
          {"height", mode.vdisplay},
          {"clocks_per_pixel", clocks_per_pixel},
          {"displays_per_second", displays_per_second},
          {"pixels_different", differ}};
}

}  // namespace dynrt::host
