// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clocks that cores reached when they were placed and routed: hls/configs/clocks.json.
#pragma once

#include <span>
#include <string>

namespace dynrt::host {

/// One placement of a core.
struct PlacedClock {
  std::string configuration;  ///< a listed one
  std::string device;         ///< as scripts/place names it
  std::string part;           ///< the device in words
  std::string grade;          ///< empty on a device that has but one
  double mhz = 0;             ///< median of the seeds
  double lowest_mhz = 0;
  double highest_mhz = 0;
  unsigned seeds = 0;
  std::string placer;   ///< with its version
  std::string date;     ///< on which it was placed: year, month and day
  std::string verilog;  ///< a hash of what was placed

  std::string where() const { return part + (grade.empty() ? "" : ", grade " + grade); }
};

/// All of them, never none; the first has the device and the grade that stand without flags.
std::span<const PlacedClock> placed_clocks();

}  // namespace dynrt::host
