// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clock of the core that frames per second are stated for, and where it comes from.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/app/placed_clock.h"
#include "host/format/core_info.h"

namespace dynrt::host {

struct CoreClock {
  double mhz = 0;
  const PlacedClock* placed = nullptr;  ///< null: the user or the board gave the clock
  bool own = false;                     ///< whether this very configuration was placed
  std::string configuration = {};       ///< that the clock is used for
  bool of_board = false;                ///< the board gave the clock

  double hz() const { return mhz * 1e6; }
  /// A line that says where the clock comes from.
  std::string text() const;
  nlohmann::ordered_json json() const;
};

/// The flags that choose the clock.
struct ClockFlags {
  std::optional<double> mhz;
  std::string device = placed_clocks().front().device;
  std::optional<std::string> grade;  ///< without the flag the device's first

  void add_to(CLI::App& command);
  /// Throws UserError for a clock that none can have, and for a device or grade that no core was
  /// placed on.
  void check() const;
  /// The clock of a core: the one given, else the board's, else that of its placement, else the
  /// slowest that a core reached on the device.
  CoreClock clock_of(const CoreInfo& core, std::optional<double> board_hz = std::nullopt) const;

 private:
  const PlacedClock& first_on_device() const;
};

}  // namespace dynrt::host
