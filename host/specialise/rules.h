// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One rule for each key of a configuration that a scene decides. Both the specialised core
// (decide.h) and the check of later frames against it (within.h) follow from these rules.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "configs/core_configuration.h"
#include "host/specialise/scene_needs.h"

namespace dynrt::host {

/// The options of the frames, in addition to the scene.
struct FrameDemands {
  unsigned reflections = 0;  ///< largest number of bounces
  bool uncompressed = false;
};

struct RuleContext {
  const SceneNeeds& needs;
  /// The general core for the scene, if it is known; no rule asks for a part that it lacks.
  const CoreConfiguration* general = nullptr;
  FrameDemands demands{};
  Datapath datapath = Datapath::kThesis;  ///< of the core
  bool two_levels = false;  ///< the core has them, whether the scene needs them or not
};

struct Need {
  nlohmann::ordered_json value;
  std::string reason;  ///< a sentence without its full stop
};

/// The condition under which a core's value satisfies a need.
enum class Holds : std::uint8_t {
  kAlways,      ///< with any value: no frame can exceed it
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
