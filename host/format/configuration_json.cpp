// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/format/configuration_json.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "hls/json_text.h"

namespace dynrt {

namespace {

template <class Value>
Json json_of_value(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    const auto names = names_of(value);
    return std::ranges::find(names, value, &decltype(names)::value_type::first)->second;
  } else if constexpr (requires { members_of(value); }) {
    Json list = Json::array();
    for (const auto& [member, name] : members_of(value)) {
      if (value.*member) list.push_back(name);
    }
    return list;
  } else {
    return hls::with_whole_numbers(Json(value));
  }
}

template <class Value>
void read(const Json& json, Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    const auto names = names_of(value);
    const auto found =
        std::ranges::find(names, json.get<std::string>(), &decltype(names)::value_type::second);
    if (found == names.end()) throw std::invalid_argument(json.dump());
    value = found->first;
  } else if constexpr (requires { members_of(value); }) {
    const auto listed = json.get<std::vector<std::string>>();
    for (const auto& [member, name] : members_of(value)) {
      value.*member = std::ranges::find(listed, name) != listed.end();
    }
  } else {
    value = json.get<Value>();
  }
}

/// The value of a key, which may stand beside its reason.
const Json& without_reason(const Json& stated) {
  return stated.is_object() ? stated.at("value") : stated;
}

/// What a configuration has before its own keys are read.
CoreConfiguration base_of(const Json& json) {
  const auto like = json.find("like");
  if (like == json.end()) return {};
  const CoreConfiguration* listed = listed_configuration(like->get<std::string>());
  if (listed == nullptr) throw std::invalid_argument("like " + like->dump());
  return inherited_from(*listed);
}

}  // namespace

Json json_of(const CoreConfiguration& configuration) {
  Json json = {{"name", configuration.name}};
  for_each_key(configuration, [&](const ConfigurationKey& key, const auto& value) {
    json[std::string(key.name)] = json_of_value(value);
  });
  return json;
}

Json value_of(const CoreConfiguration& configuration, std::string_view name) {
  std::optional<Json> found;
  for_each_key(configuration, [&](const ConfigurationKey& key, const auto& value) {
    if (key.name == name) found = json_of_value(value);
  });
  if (!found) throw std::out_of_range(std::string(name));
  return *found;
}

CoreConfiguration configuration_of(const Json& json) {
  CoreConfiguration configuration = base_of(json);
  configuration.name = json.value("name", "");
  for (const auto& [key, value] : json.items()) {
    const std::string_view instead = in_place_of(key);
    if (instead.empty()) continue;
    throw std::invalid_argument("the key '" + key + "' is gone; " + std::string(instead));
  }
  for_each_key(configuration, [&](const ConfigurationKey& key, auto& value) {
    const auto stated = json.find(key.name);
    if (stated == json.end()) return;
    try {
      read(without_reason(*stated), value);
    } catch (const std::exception& error) {
      throw std::invalid_argument("key '" + std::string(key.name) + "': " + error.what());
    }
  });
  return configuration;
}

}  // namespace dynrt
