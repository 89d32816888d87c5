// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/decide.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "host/error.h"
#include "host/format/configuration_json.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

/// The need, limited to the key's smallest value and to the general core's value.
Json bounded(const ConfigurationKey& key, const Json& need, const Json& general) {
  if (!need.is_number() || !general.is_number_integer()) return need;
  const auto least = static_cast<std::int64_t>(key.low);
  return std::max(least, std::min(need.get<std::int64_t>(), general.get<std::int64_t>()));
}

Decision decision(const ConfigurationKey& key, const RuleContext& context) {
  const Json general = value_of(*context.general, key.name);
  const Rule* rule = rule_of(key.name);
  if (rule == nullptr) {
    const std::string_view why =
        key.kept.empty() ? std::string_view("another value would change the bits") : key.kept;
    return {std::string(key.name), general,
            fmt::format("as in {}: {}", context.general->name, why)};
  }
  Need need = rule->need(context);
  return {std::string(key.name), need.value.is_null() ? general : bounded(key, need.value, general),
          std::move(need.reason)};
}

}  // namespace

std::vector<Decision> decide(const SceneNeeds& needs, const CoreConfiguration& general,
                             const FrameDemands& demands) {
  const RuleContext context{needs, &general, demands, general.datapath};
  std::vector<Decision> decisions;
  for_each_key(general, [&](const ConfigurationKey& key, const auto&) {
    if (key.of_core) decisions.push_back(decision(key, context));
  });
  return decisions;
}

std::vector<Decision> replaced(std::vector<Decision> decisions, const std::vector<Decision>& by) {
  for (Decision& decision : decisions) {
    const auto other = std::ranges::find(by, decision.key, &Decision::key);
    if (other != by.end()) decision = *other;
  }
  return decisions;
}

std::vector<Decision> kept(const std::vector<std::string>& keys, const CoreConfiguration& general) {
  std::vector<std::string_view> known;
  for_each_key(general, [&](const ConfigurationKey& key, const auto&) {
    if (key.of_core) known.push_back(key.name);
  });
  std::vector<Decision> decisions;
  for (const std::string& key : keys) {
    if (std::ranges::find(known, key) == known.end()) {
      refuse("there is no key '{}' to keep; the keys are {}", key,
             fmt::format("{}", fmt::join(known, ", ")));
    }
    decisions.push_back(
        {key, value_of(general, key), fmt::format("as in {}: it was asked for", general.name)});
  }
  return decisions;
}

std::vector<std::string> left_out(const std::vector<Decision>& decisions,
                                  const CoreConfiguration& general) {
  std::vector<std::string> keys;
  for (const Decision& decision : decisions) {
    if (decision.value != value_of(general, decision.key)) keys.push_back(decision.key);
  }
  return keys;
}

Json configuration_json(const std::vector<Decision>& decisions, const std::string& scene,
                        const CoreConfiguration& general, const std::string& made_from) {
  Json json = {{"about", fmt::format("made for the scene {}, from the configuration {}", scene,
                                     general.name)},
               {"made_for", scene},
               {"made_from", made_from}};
  json.update(json_of(decisions));
  return json;
}

std::string words_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (!value.is_array()) return value.dump();
  return fmt::format("{}", fmt::join(value.get<std::vector<std::string>>(), ", "));
}

Json json_of(const std::vector<Decision>& decisions) {
  Json json = Json::object();
  for (const Decision& decision : decisions) {
    json[decision.key] = {{"value", decision.value}, {"reason", decision.reason}};
  }
  return json;
}

Json json_of(const SceneNeeds& needs) {
  const auto stack = [](const SceneNeeds::Stack& s) {
    return Json{{"pushes", s.pushes}, {"tree", s.tree}};
  };
  const auto repeats = [](const SceneNeeds::Repeats& r) {
    return Json{{"items", r.items}, {"repeated", r.repeated}, {"tree", r.tree}};
  };
  return {{"scene", needs.scene},
          {"frames", needs.frames},
          {"objects", needs.objects},
          {"instances", needs.instances},
          {"one_level", needs.one_level},
          {"top_stack", stack(needs.top_stack)},
          {"object_stack", stack(needs.object_stack)},
          {"instance_repeats", repeats(needs.instance_repeats)},
          {"primitive_repeats", repeats(needs.primitive_repeats)},
          {"triangles", needs.primitives.triangles},
          {"rectangles", needs.primitives.rectangles},
          {"spheres", needs.primitives.spheres},
          {"lights", needs.lights},
          {"mirror", needs.mirror},
          {"colours", needs.colours.size()},
          {"nodes", needs.places.nodes},
          {"list_entries", needs.places.entries},
          {"matrices", needs.places.matrices}};
}

}  // namespace dynrt::host
