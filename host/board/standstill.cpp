// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/standstill.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "hls/counter_name.h"

namespace dynrt::host {

namespace {

constexpr std::string_view kTransactions = hls::suffix_of(hls::Counted::kTransactions);

/// Whether the counter `name` went on between the readings.
bool went_on(std::span<const Counter> before, std::span<const Counter> after,
             std::string_view name) {
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (after[i].name == name) return after[i].value != before[i].value;
  }
  return false;
}

}  // namespace

std::string where_units_stand(std::span<const Counter> before, std::span<const Counter> after) {
  if (after.empty()) return "not known, as the configuration has no counters";
  std::vector<std::string> stalled, at_work, without_input;
  for (const Counter& counter : after) {
    if (!counter.name.ends_with(kTransactions)) continue;
    const std::string unit = counter.name.substr(0, counter.name.size() - kTransactions.size());
    auto& group = went_on(before, after, hls::counter_name(unit, hls::Counted::kStalls)) ? stalled
                  : went_on(before, after, counter.name)                                 ? at_work
                                                         : without_input;
    group.push_back(fmt::format("{} {}", unit, counter.value));
  }
  std::vector<std::string> groups;
  const auto tell = [&groups](const char* state, const std::vector<std::string>& units) {
    if (!units.empty()) groups.push_back(fmt::format("{}: {}", state, fmt::join(units, ", ")));
  };
  tell("stalled", stalled);
  tell("at work", at_work);
  tell("without input", without_input);
  return fmt::format("{}", fmt::join(groups, "; "));
}

}  // namespace dynrt::host
