// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/dvi_monitor.h"

#include <fmt/format.h>

#include <algorithm>

namespace dynrt::host {

namespace {

constexpr unsigned kClockPair = 3;
constexpr const char* kNames[] = {"blue", "green", "red", "clock"};
/// Characters of blanking, one after another, that tell where a character begins; a picture has
/// none by chance, and the shortest blanking of the standard modes has ten times as many.
constexpr unsigned kEnough = 12;

}  // namespace

std::optional<unsigned> DviMonitor::Receiver::take(unsigned bits) {
  history = history >> kBits | bits << kBits;
  for (unsigned at = 0; at < kBits; ++at) {
    const bool blank = tmds::control_of(history >> at & 0x3ff).has_value();
    control[at] = blank ? control[at] + 1 : 0;
    if (control[at] == kEnough) begins = at;
  }
  if (!begins) return std::nullopt;
  return history >> *begins & 0x3ff;
}

void DviMonitor::sample(std::uint64_t time_ps, DviPins pins) {
  if (pins == pins_ && !changes_.empty()) return;
  const bool rises =
      (pins.positive >> kClockPair & 1) != 0 && (pins_.positive >> kClockPair & 1) == 0;
  pins_ = pins;
  for (unsigned pair = 0; pair <= kClockPair; ++pair) {
    if ((pins.positive >> pair & 1) != (pins.negative >> pair & 1)) continue;
    fail(fmt::format("both wires of {} are {} at {} ps", kNames[pair], pins.positive >> pair & 1,
                     time_ps));
    lose_link();
    return;
  }
  if (rises) {
    if (!changes_.empty()) look_at_cycle(time_ps);
    changes_.clear();
  }
  if (rises || !changes_.empty()) changes_.emplace_back(time_ps, pins);
}

/// The ten bits of each channel between two rises of the clock pair, each in its middle.
void DviMonitor::look_at_cycle(std::uint64_t end) {
  const std::uint64_t begin = changes_.front().first;
  const auto period = static_cast<unsigned>(end - begin);
  if (period_ != 0 && period != period_) {
    fail(fmt::format("the clock rises after {} ps at {} ps, before that after {} ps", period, end,
                     period_));
  }
  period_ = period;
  std::array<unsigned, kChannels> bits{};
  auto held = changes_.begin();
  for (unsigned bit = 0; bit < kBits; ++bit) {
    const std::uint64_t middle = begin + std::uint64_t{2 * bit + 1} * period / (2 * kBits);
    while (held + 1 != changes_.end() && (held + 1)->first <= middle) ++held;
    for (unsigned c = 0; c < kChannels; ++c) bits[c] |= (held->second.positive >> c & 1) << bit;
  }
  std::array<unsigned, kChannels> characters{};
  bool all = true;
  for (unsigned c = 0; c < kChannels; ++c) {
    const auto character = receivers_[c].take(bits[c]);
    all = all && character.has_value();
    characters[c] = character.value_or(0);
  }
  if (all) take_pixel(characters, period);
}

void DviMonitor::take_pixel(const std::array<unsigned, kChannels>& characters, unsigned period) {
  const auto syncs = tmds::control_of(characters[0]);
  const bool visible = !syncs.has_value();
  FrameMeter::Pixel pixel{.visible = visible, .time = period};
  for (unsigned c = 0; c < kChannels; ++c) {
    const auto control = tmds::control_of(characters[c]);
    if (control.has_value() == visible) {
      fail(fmt::format("{} is {}, blue is {}", kNames[c], visible ? "blanked" : "visible",
                       visible ? "visible" : "blanked"));
    } else if (control && c != 0 && *control != 0) {
      fail(fmt::format("{} has the control signals {}; a DVI link leaves them 0", kNames[c],
                       *control));
    } else if (!control) {
      check_pixel(c, characters[c]);
      pixel.colour |= tmds::decode(characters[c]) << (8 * (kChannels - 1 - c));
    }
    if (control) receivers_[c].encoder = {};
  }
  if (syncs) syncs_ = *syncs;
  pixel.hsync = (syncs_ & 1) != 0;
  pixel.vsync = (syncs_ & 2) != 0;
  // Behind the last pixel of a row comes the front porch, so neither sync is in its pulse.
  if (was_visible_ && !visible && !meter_) meter_.emplace(!pixel.hsync, !pixel.vsync);
  was_visible_ = visible;
  if (meter_) meter_->take(pixel);
}

void DviMonitor::check_pixel(unsigned channel, unsigned character) {
  const unsigned byte = tmds::decode(character);
  tmds::Channel& encoder = receivers_[channel].encoder;
  const int disparity = encoder.cnt;
  const unsigned specified = encoder.encode(byte);
  if (character == specified) return;
  fail(
      fmt::format("{} sends the character {:#05x}; at the disparity {} the byte {:#04x} is {:#05x}",
                  kNames[channel], character, disparity, byte, specified));
}

void DviMonitor::fail(const std::string& what) {
  if (meter_) meter_->report(fmt::format("{}: {}", meter_->place(), what));
}

void DviMonitor::lose_link() {
  changes_.clear();
  period_ = 0;
  receivers_ = {};
  was_visible_ = false;
}

const std::vector<DisplayFrame>& DviMonitor::frames() const {
  static const std::vector<DisplayFrame> none;
  return meter_ ? meter_->frames() : none;
}

std::string DviMonitor::waits_for() const {
  if (meter_) return {};
  if (period_ == 0) return "the clock pair has no period yet";
  for (unsigned c = 0; c < kChannels; ++c) {
    if (receivers_[c].begins) continue;
    return fmt::format(
        "{} has sent no {} characters of blanking in a row, which tell where a "
        "character begins",
        kNames[c], kEnough);
  }
  return "no row of pixels has ended yet";
}

}  // namespace dynrt::host
