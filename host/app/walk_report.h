// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The report of a walk: one line for each frame, and a summary.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "host/app/core_clock.h"
#include "host/app/walk.h"

namespace dynrt::host {

/// The time of each frame with all its work: the host prepares the next frame while the core
/// renders this one, and uploads the changed words between the two.
double frame_seconds(const WalkRecord& record, double clock_hz);

std::string walk_header();
std::string walk_line(const WalkRecord& record, double clock_hz);

struct WalkSummary {
  std::span<const WalkRecord> records;
  unsigned kept = 0;  ///< frames that were there already
  BusTraffic scene_upload;
  CoreClock clock;

  std::string text() const;
  nlohmann::ordered_json json() const;
};

}  // namespace dynrt::host
