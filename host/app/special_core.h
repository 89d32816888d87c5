// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core made for a scene: rules decide what the scene needs of it, measurements on the native
// model how many packets, cache lines and nodes of a line pay. The cache keeps the decisions.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/app/cost_meter.h"

namespace dynrt::host {

struct SpecialiseWishes {
  std::string general{};            ///< the general configuration's name or file
  std::vector<std::string> keep{};  ///< keys that stay as they are there
  double max_slowdown = 2;          ///< percent more clocks for fewer packets and lines
  AnalysedFrames frames{};
  std::vector<Decision> formats{};  ///< the keys of another number format
  unsigned jobs = 0;                ///< compilers at a time; 0: one for each processor
};

struct SpecialCore {
  std::string configuration;  ///< its file, in the cache
  CoreConfiguration general;
  std::string about;  ///< a line about the scene
  /// What decided it: "general", "needs", "layouts" by nodes of a line, "curves" of clocks by
  /// packets and lines, "left_out", the keys that differ, and "configuration", every key.
  nlohmann::ordered_json analysis;
};

/// Throws UserError in a program that was built without hlsc.
void require_whole_build();

/// The scene should be kept (SceneFile). Throws UserError where no core can be made.
SpecialCore special_core(SceneFile& scene, const SpecialiseWishes& wishes);

/// A configuration that is listed, or a file of one, with its units lowered and its model made.
LoweredCore lowered(const std::string& configuration, unsigned jobs);

/// The name of a scene's core, from the scene's name or file: letters, digits, _, - and dots.
std::string core_name(const std::string& scene);

}  // namespace dynrt::host
