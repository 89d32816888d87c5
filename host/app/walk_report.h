// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What is printed about a walk: a line a frame, and what it was like as a whole.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "host/app/walk.h"

namespace dynrt::host {

/// One number for each frame that all its work is in: while a frame is rendered the host prepares
/// the next; what has changed goes over the bus between the two.
double frame_seconds(const WalkRecord& record, double clock_hz);

std::string walk_header();
std::string walk_line(const WalkRecord& record, double clock_hz);

struct WalkSummary {
  std::span<const WalkRecord> records;
  unsigned kept = 0;  ///< frames that were there already
  BusTraffic scene_upload;
  double clock_hz = 0;

  std::string text() const;
  nlohmann::ordered_json json() const;
};

}  // namespace dynrt::host
