// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The value that each key of a configuration must have for a scene, with a sentence that gives the
// reason. The key's rule decides it (rules.h); a key without a rule has the general core's value.
// `dynrt specialise` measures afterwards how many packets and cache lines pay.
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

nlohmann::ordered_json json_of(const std::vector<Decision>& decisions);
/// The figures behind the decisions.
nlohmann::ordered_json json_of(const SceneNeeds& needs);

}  // namespace dynrt::host
