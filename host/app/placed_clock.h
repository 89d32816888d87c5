// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clocks that cores reached when they were placed and routed.
#pragma once

#include <span>
#include <string_view>

namespace dynrt::host {

/// One placement, as the build copies it from the kept data.
struct PlacedClock {
  std::string_view device;         ///< as scripts/place names it
  std::string_view grade;          ///< empty on a device that has but one
  std::string_view configuration;  ///< a listed one
  double mhz = 0;                  ///< median of the seeds
  double lowest_mhz = 0;
  double highest_mhz = 0;
  unsigned seeds = 0;
  std::string_view placer;   ///< with its version
  std::string_view verilog;  ///< a hash of what was placed
  bool earlier = false;      ///< the checked-in Verilog is another by now
  std::string_view command;  ///< that measures it again
  std::string_view where;    ///< device and grade in words
};

/// All of them, never none: the default device and grade first, and of each device and grade first
/// the one that stands in for the configurations that were not placed.
std::span<const PlacedClock> placed_clocks();

}  // namespace dynrt::host
