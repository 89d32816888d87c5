// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A DVI monitor: finds the picture and the mode at the four pairs of a link. It knows only the pins
// and when they change: the clock pair gives it the time of a bit, the characters of the blanking
// where a character begins on each channel, the end of a row the polarity of the syncs. It holds
// every character against the specification, and says where the link departs from it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/board/frame_meter.h"
#include "units/tmds_specification.h"

namespace dynrt::host {

/// The wires of the pairs: bit 0 blue, 1 green, 2 red, 3 clock.
struct DviPins {
  unsigned positive = 0;
  unsigned negative = 0;
  friend bool operator==(const DviPins&, const DviPins&) = default;
};

class DviMonitor {
 public:
  /// The pins from `time_ps` on; they may be told more often than they change.
  void sample(std::uint64_t time_ps, DviPins pins);

  /// Those that were seen whole.
  const std::vector<DisplayFrame>& frames() const;
  /// What the monitor waits for before it can see frames; empty if it sees them.
  std::string waits_for() const;

 private:
  static constexpr unsigned kChannels = 3;
  static constexpr unsigned kBits = 10;  ///< of a character

  /// One channel: where its characters begin, and its disparity.
  struct Receiver {
    std::uint32_t history = 0;              ///< the latest bits, bit 0 the oldest of two cycles
    std::array<unsigned, kBits> control{};  ///< at each beginning, characters of blanking in a row
    std::optional<unsigned> begins;
    tmds::Channel encoder;

    /// Takes the bits of a cycle of the clock pair; the character that it ends, if that is known.
    std::optional<unsigned> take(unsigned bits);
  };
  void look_at_cycle(std::uint64_t end);
  void take_pixel(const std::array<unsigned, kChannels>& characters, unsigned period);
  void check_pixel(unsigned channel, unsigned character);
  void fail(const std::string& what);
  void lose_link();

  std::vector<std::pair<std::uint64_t, DviPins>> changes_;  ///< since the clock pair last rose
  DviPins pins_;
  unsigned period_ = 0;  ///< of the clock pair, in ps
  std::array<Receiver, kChannels> receivers_;
  bool was_visible_ = false;
  unsigned syncs_ = 0;  ///< of the last pixel of blanking
  std::optional<FrameMeter> meter_;
};

}  // namespace dynrt::host
