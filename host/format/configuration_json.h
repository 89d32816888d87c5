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

/// Reads the result of json_of(). A missing key gets its default; throws std::invalid_argument for
/// a value of another type.
CoreConfiguration configuration_of(const Json& json);

}  // namespace dynrt
