// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a frame takes on the native model of a core, by the schedules of the core's Verilog.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "host/app/prepare.h"
#include "host/app/scene_analysis.h"
#include "host/specialise/search.h"

namespace dynrt::host {

/// A core whose units are lowered.
struct LoweredCore {
  std::string configuration;  ///< its name, or FILE.json
  std::string verilog;        ///< the folder with its Verilog and its schedules
};

/// The scene should be kept (SceneFile), as each core lays it out anew.
class CostMeter {
 public:
  CostMeter(SceneFile& file, const AnalysedFrames& frames);

  /// Of a frame with so many packets and lines in use; each is rendered once.
  FrameCosts count(const LoweredCore& core, unsigned packets, unsigned lines);

 private:
  SceneFile& file_;
  FrameArguments frame_;
  std::string configuration_;  ///< that the scene was last laid out for
  std::optional<Prepared> prepared_;
  std::map<std::tuple<std::string, unsigned, unsigned>, FrameCosts> known_;
};

}  // namespace dynrt::host
