// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a scene asks of a core, before one is made for it.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/app/scene_file.h"
#include "host/specialise/decide.h"

namespace dynrt::host {

/// The configuration that renders a scene without being made for it: fast, for a scene with light
/// or mirrors whitted, for one of other primitives than triangles primitives.
std::string general_configuration(SceneFile& file);

/// The frames that a core must hold.
struct AnalysedFrames {
  std::optional<unsigned> reflections{};  ///< bounces; all that the general configuration has
  bool uncompressed = false;
  std::optional<unsigned> frames{};  ///< of a walk; kWalkFrames of a scene that moves, else one
  SpanArguments span{};
  MemoryArguments memory{};  ///< of the frame whose clocks are measured

  void add_to(CLI::App& command);
};

struct SceneAnalysis {
  std::string general;        ///< the configuration that the core is to be made from
  std::uint64_t content = 0;  ///< fingerprint of the scene
  std::string text;           ///< about the scene and its trees
  SceneNeeds needs;
  std::vector<Decision> decisions;

  nlohmann::ordered_json json() const;
  std::string about() const;  ///< the line about the scene, without its title
};

/// Over all frames. `configuration` is the general one, or empty: then the scene decides.
SceneAnalysis analyse(SceneFile& file, const std::string& configuration,
                      const AnalysedFrames& frames);

}  // namespace dynrt::host
