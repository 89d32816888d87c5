// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Answers the questions of scripts/specialise about a scene: the script builds, and this program
// analyses and renders, with the scene in memory.
#pragma once

#include <optional>
#include <string>

#include "host/app/board_frame.h"
#include "host/app/scene_analysis.h"

namespace dynrt::host {

/// The cost of a frame on the native model, by the schedules of a core's Verilog.
struct FrameCosts {
  std::uint64_t clocks = 0;
  std::optional<double> bytes_per_ray;  ///< read of the scene; none without counters
};

/// Counts the cost of frames.
class CostMeter {
 public:
  CostMeter(SceneFile& file, const AnalysedFrames& frames);

  FrameCosts count(const std::string& configuration, const std::string& schedules, unsigned packets,
                   unsigned lines);

 private:
  SceneFile& file_;
  FrameArguments frame_;
  std::string configuration_;  ///< that the scene was last laid out for
  std::optional<Prepared> prepared_;
};

/// A question is a line of JSON, and so is its answer; {"refused": SENTENCE} for a mistake of the
/// user.
///   {"ask": "needs", "configuration": NAME}    what `dynrt needs --json` writes, and "about";
///                                              without a name of the general configuration
///   {"ask": "frame", "configuration": FILE, "schedules": FOLDER, "packets": N, "lines": N}
///                                              {"clocks": N, "bytes_per_ray": X or null}
class Analyst {
 public:
  /// The scene should be kept (SceneFile), as every question needs it.
  Analyst(SceneFile& file, AnalysedFrames frames);

  std::string answer(const std::string& question);

 private:
  nlohmann::ordered_json answered(const nlohmann::ordered_json& question);

  SceneFile& file_;
  AnalysedFrames frames_;
  CostMeter meter_;
};

}  // namespace dynrt::host
