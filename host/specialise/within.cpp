// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/specialise/within.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/format/configuration_json.h"
#include "host/specialise/rules.h"
#include "host/specialise/specialise_messages.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

bool is_held(Holds how, const Json& need, const Json& has) {
  switch (how) {
    case Holds::kAlways:
      return true;
    case Holds::kFromNeedOn:
      return need.get<std::uint64_t>() <= has.get<std::uint64_t>();
    case Holds::kWithAll:
      return std::ranges::all_of(
          need, [&](const Json& one) { return std::ranges::find(has, one) != has.end(); });
    case Holds::kUnlessSet:
      return need.get<bool>() || !has.get<bool>();
  }
  return false;
}

std::string text_of(const Json& value) {
  if (!value.is_array()) return value.dump();
  return fmt::format("{}", fmt::join(value.get<std::vector<std::string>>(), ", "));
}

}  // namespace

std::optional<Excess> excess(const SceneNeeds& needs, const CoreInfo& core) {
  const RuleContext context{.needs = needs,
                            .general = core.general.get(),
                            .datapath = core.datapath,
                            .two_levels = core.levels == 2};
  for (const Rule& rule : rules()) {
    if (rule.holds == Holds::kAlways) continue;
    const Json need = rule.need(context).value;
    const Json has = value_of(core, rule.key);
    if (!is_held(rule.holds, need, has)) return Excess{rule.key, text_of(need), text_of(has)};
  }
  return std::nullopt;
}

void refuse_excess(const Excess& over, const CoreInfo& core, const std::string& frame) {
  throw Exceeded(fmt::format(messages::kExceeded, frame, over.key, over.needs, core.name,
                             core.made_for, over.has));
}

void check_within(const SceneNeeds& needs, const CoreInfo& core, const std::string& frame) {
  if (const auto over = excess(needs, core)) refuse_excess(*over, core, frame);
}

}  // namespace dynrt::host
