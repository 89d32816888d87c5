// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What every key of a configuration must be for a scene, each with a sentence that says why: by its
// rule (rules.h), or as in the general core where no scene decides it. How many packets and lines
// pay is found by measuring, which `dynrt specialise` does after this.
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

/// In the order of the configurations' keys. `general` is the core that renders the scene without
/// being made for it: of what that leaves out nothing is asked for.
std::vector<Decision> decide(const SceneNeeds& needs, const CoreConfiguration& general,
                             const FrameDemands& demands);

nlohmann::ordered_json json_of(const std::vector<Decision>& decisions);
/// The figures that the decisions come from.
nlohmann::ordered_json json_of(const SceneNeeds& needs);

}  // namespace dynrt::host
