// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/frame_meter.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace dynrt::host {

void FrameMeter::take(Pixel pixel) {
  pixel.hsync = pixel.hsync == positive_hsync_;
  pixel.vsync = pixel.vsync == positive_vsync_;
  if (pixel.vsync && !in_pulse_) {
    if (whole_) frames_.push_back(frame_of_pixels());
    whole_ = true;
    pixels_.clear();
    fault_.clear();
    lines_ = 0;
    columns_ = 0;
  }
  in_pulse_ = pixel.vsync;
  if (pixel.hsync && !pixels_.empty() && !pixels_.back().hsync) {
    ++lines_;
    columns_ = 0;
  }
  ++columns_;
  if (whole_) pixels_.push_back(pixel);
}

std::string FrameMeter::place() const {
  return fmt::format("pixel {} of line {}", columns_, lines_);
}

void FrameMeter::report(const std::string& fault) {
  if (fault_.empty()) fault_ = fault;
}

DisplayFrame FrameMeter::frame_of_pixels() const {
  DisplayFrame frame;
  frame.mode.positive_hsync = positive_hsync_;
  frame.mode.positive_vsync = positive_vsync_;
  frame.pixel_time = pixels_.front().time;
  frame.fault = fault_;
  if (!frame.fault.empty()) return frame;
  const auto slow = std::ranges::find_if(
      pixels_, [&frame](const Pixel& p) { return p.time != frame.pixel_time; });
  if (slow != pixels_.end()) {
    frame.fault = fmt::format("one pixel comes after {} clocks, another after {}", frame.pixel_time,
                              slow->time);
    return frame;
  }
  frame.fault = measure_lines(frame);
  if (frame.fault.empty()) frame.fault = measure_rows(frame);
  return frame;
}

/// Total and sync pulse of lines and display. A line begins with its horizontal pulse here.
std::string FrameMeter::measure_lines(DisplayFrame& frame) const {
  DisplayMode& m = frame.mode;
  std::vector<std::size_t> begins;
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i < pixels_.size(); ++i) {
    if (pixels_[i].hsync && !pixels_[i - 1].hsync) begins.push_back(i);
    if (!pixels_[i].hsync && pixels_[i - 1].hsync) ends.push_back(i);
  }
  if (begins.size() < 2 || begins.size() != ends.size() || ends.front() < begins.front()) {
    return fmt::format("{} horizontal pulses begin and {} end", begins.size(), ends.size());
  }
  m.htotal = static_cast<unsigned>(begins[1] - begins[0]);
  m.vtotal = static_cast<unsigned>(begins.size());
  for (std::size_t line = 0; line < begins.size(); ++line) {
    if (begins[line] != begins[0] + line * m.htotal ||
        ends[line] - begins[line] != ends[0] - begins[0]) {
      return fmt::format("line {} has its pulse from pixel {} to {}, line 0 from {} to {}", line,
                         begins[line], ends[line], begins[0], ends[0]);
    }
  }
  const auto vertical = static_cast<std::size_t>(
      std::ranges::count_if(pixels_, [](const Pixel& p) { return p.vsync; }));
  if (pixels_.size() != std::size_t{m.vtotal} * m.htotal || vertical % m.htotal != 0) {
    return fmt::format(
        "{} lines of {} pixels have {} pixels in all, {} of them in the vertical pulse", m.vtotal,
        m.htotal, pixels_.size(), vertical);
  }
  m.hsync_end = static_cast<unsigned>(ends[0] - begins[0]);  // from the pulse's beginning, so far
  m.vsync_end = static_cast<unsigned>(vertical / m.htotal);
  return {};
}

/// The picture, and where the pulses lie from its top left corner on.
std::string FrameMeter::measure_rows(DisplayFrame& frame) const {
  DisplayMode& m = frame.mode;
  const auto visible = [](const Pixel& p) { return p.visible; };
  const auto first = std::ranges::find_if(pixels_, visible);
  if (first == pixels_.end()) return "no pixel is visible";
  const auto corner = static_cast<std::size_t>(first - pixels_.begin());
  m.hdisplay =
      static_cast<unsigned>(std::find_if(first, pixels_.end(), std::not_fn(visible)) - first);
  const auto all = static_cast<std::size_t>(std::ranges::count_if(pixels_, visible));
  m.vdisplay = static_cast<unsigned>(all / m.hdisplay);
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const std::size_t after = i - corner;
    const bool inside =
        i >= corner && after % m.htotal < m.hdisplay && after / m.htotal < m.vdisplay;
    const Pixel& p = pixels_[i];
    if (p.visible != inside)
      return fmt::format("the visible pixels do not form a rectangle at pixel {}", i);
    if (!p.visible && p.colour != 0)
      return fmt::format("pixel {} has a colour but lies in the blanking", i);
    if (p.visible) frame.pixels.push_back(p.colour);
  }
  if ((pixels_.size() - corner) % m.htotal != 0) {
    return fmt::format("the vertical pulse begins {} pixels after the corner",
                       pixels_.size() - corner);
  }
  const auto pulse = std::find_if(first, pixels_.end(), [](const Pixel& p) { return p.hsync; });
  m.hsync_start = static_cast<unsigned>(pulse - first);
  m.hsync_end += m.hsync_start;
  m.vsync_start = static_cast<unsigned>((pixels_.size() - corner) / m.htotal);
  m.vsync_end += m.vsync_start;
  return {};
}

}  // namespace dynrt::host
