// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One rule for each key of a configuration that a scene decides. What a core is specialised to
// (decide.h) and what a frame may exceed of it (within.h) both follow from these.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "configs/core_configuration.h"
#include "host/specialise/scene_needs.h"

namespace dynrt::host {

/// What is asked of the frames, besides the scene.
struct FrameDemands {
  unsigned reflections = 0;  ///< bounces, at most
  bool uncompressed = false;
};

struct RuleContext {
  const SceneNeeds& needs;
  /// The core that renders the scene without being made for it, if it is known: of what that leaves
  /// out nothing is asked for.
  const CoreConfiguration* general = nullptr;
  FrameDemands demands{};
  bool two_levels = false;  ///< the core has them, whether the scene needs them or not
};

struct Need {
  nlohmann::ordered_json value;
  std::string reason;  ///< a sentence without its full stop
};

/// When a core's value holds a need.
enum class Holds : std::uint8_t {
  kAlways,      ///< whatever it is: no frame can exceed it
  kFromNeedOn,  ///< a number that is not smaller
  kWithAll,     ///< a list with all that the need lists
  kUnlessSet,   ///< a flag that is set only if the need sets it
};

struct Rule {
  const char* key;
  Holds holds;
  Need (*need)(const RuleContext&);  ///< a general core is known where `holds` is kAlways
};

std::span<const Rule> rules();

/// The rule of a key, or null.
const Rule* rule_of(std::string_view key);

}  // namespace dynrt::host
