// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The page that `dynrt specialise` prints: the keys that differ, each with its reason, the savings,
// and the curves.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "configs/core_configuration.h"

namespace dynrt::host {

/// `result` is a SpecialCore::analysis with "costs": of the core "general" and the core "special",
/// by name (specialise_page.cpp). `about` is a line about the scene.
std::string specialise_page(const std::string& about, const CoreConfiguration& general,
                            const nlohmann::ordered_json& result);

/// By how much less the special core takes, in percent of the general one, with one decimal.
nlohmann::ordered_json savings(const nlohmann::ordered_json& general,
                               const nlohmann::ordered_json& special);

}  // namespace dynrt::host
