// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A configuration as JSON and back, key by key as hls/configs/configs.json has them.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "configs/core_configuration.h"

namespace dynrt {

using Json = nlohmann::ordered_json;

/// Every key, in the order of the table, after the name.
Json json_of(const CoreConfiguration& configuration);

/// The value of one key; throws std::out_of_range for an unknown one.
Json value_of(const CoreConfiguration& configuration, std::string_view key);

/// Reads a user's file or the result of json_of(). A value may have its reason beside it, as in
/// {"value": ..., "reason": ...}. A missing key gets the value of the listed configuration that
/// `like` names, else its default. Throws std::invalid_argument for a value of another type and for
/// an unknown `like`.
CoreConfiguration configuration_of(const Json& json);

/// The keys of a configuration that is `like` another: the table of keys states those that it
/// inherits; the others have their defaults. Generated with the listed configurations.
CoreConfiguration inherited_from(const CoreConfiguration& other);

}  // namespace dynrt
