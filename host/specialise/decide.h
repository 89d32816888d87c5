// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The value that each key of a configuration must have for a scene, with a sentence that gives the
// reason. The key's rule decides it (rules.h); a key without a rule has the general core's value.
// Measurements decide afterwards how many packets and cache lines pay (search.h).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/specialise/rules.h"

namespace dynrt::host {

struct Decision {
  std::string key;
  nlohmann::ordered_json value;
  std::string reason;  ///< a sentence without its full stop
};

/// In the order of the configurations' keys. `general` is the general core for the scene; no
/// decision asks for a part that it lacks.
std::vector<Decision> decide(const SceneNeeds& needs, const CoreConfiguration& general,
                             const FrameDemands& demands);

/// The same, with those of `by` in place of those for their keys.
std::vector<Decision> replaced(std::vector<Decision> decisions, const std::vector<Decision>& by);
/// For --keep: keys of the core that stay as they are. Throws UserError for others.
std::vector<Decision> kept(const std::vector<std::string>& keys, const CoreConfiguration& general);
/// The names of the keys that are not as in the general core.
std::vector<std::string> left_out(const std::vector<Decision>& decisions,
                                  const CoreConfiguration& general);

/// A configuration as a file states it, every value with its reason. `made_from` is the general
/// one's name or file.
nlohmann::ordered_json configuration_json(const std::vector<Decision>& decisions,
                                          const std::string& scene,
                                          const CoreConfiguration& general,
                                          const std::string& made_from);
nlohmann::ordered_json json_of(const std::vector<Decision>& decisions);
/// The value of a key in words: "yes", "triangle, sphere".
std::string words_of(const nlohmann::ordered_json& value);
/// The figures behind the decisions.
nlohmann::ordered_json json_of(const SceneNeeds& needs);

}  // namespace dynrt::host
