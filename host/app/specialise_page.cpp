// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/specialise_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "host/format/configuration_json.h"
#include "host/specialise/search.h"
#include "host/words.h"

namespace dynrt::host {

namespace {

/// The figures that are printed of both cores, and their names.
constexpr std::pair<const char*, const char*> kCosts[] = {
    {"LUT4", "LUTs"},
    {"LUT6", "LUTs"},
    {"FF", "flip-flops"},
    {"multiplier", "multipliers"},
    {"block RAM", "block RAMs"},
    {"gates", "gates by the thesis's rule"},
    {"memory_bits", "bits of memory in these"},
    {"stages", "pipeline stages of all units"},
    {"clocks", "clocks of a frame"},
};

using Row = std::vector<std::string>;

/// Rows under one another; the columns from `right` on end flush.
std::string aligned(const std::vector<Row>& rows, std::size_t right) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += i < right ? fmt::format("  {:<{}}", row[i], widths[i])
                        : fmt::format("  {:>{}}", row[i], widths[i]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

/// The keys that differ, each with its reason, and the others.
std::string keys_text(const CoreConfiguration& general, const Json& result) {
  const auto left_out = result.at("left_out").get<std::vector<std::string>>();
  std::vector<Row> rows = {{"key", general.name, "here", "because"}};
  std::string same;
  for (const auto& [key, decided] : result.at("configuration").items()) {
    const std::string value = words_of(decided.at("value"));
    if (std::ranges::find(left_out, key) == left_out.end()) {
      same += fmt::format("{} {} {}", same.empty() ? ":" : ",", key, value);
    } else {
      rows.push_back({key, words_of(value_of(general, key)), value, decided.at("reason")});
    }
  }
  return aligned(rows, 4) + fmt::format("\n  as in {}{}\n", general.name, same);
}

std::string costs_text(const CoreConfiguration& general, const Json& costs) {
  std::vector<Row> rows = {{"takes", general.name, "here", "less by"}};
  for (const auto& [name, about] : kCosts) {
    if (!costs.at("general").contains(name) || !costs.at("special").contains(name)) continue;
    const auto before = costs.at("general").at(name).get<std::uint64_t>();
    const auto now = costs.at("special").at(name).get<std::uint64_t>();
    const double part = static_cast<double>(now) / static_cast<double>(before);
    rows.push_back({about, grouped(before), grouped(now),
                    before == 0 ? "-" : by_percent(100 * (1 - part), "more")});
  }
  return aligned(rows, 1);
}

std::string curve_text(const std::string& name, const Json& curve) {
  if (curve.empty()) return "";
  std::vector<Row> rows = {{name}, {"clocks"}, {"more by"}};
  const auto base = curve.front().get<double>();
  for (const auto& [number, clocks] : curve.items()) {
    rows[0].push_back(number);
    rows[1].push_back(grouped(clocks.get<std::uint64_t>()));
    rows[2].push_back(by_percent(100 * (clocks.get<double>() / base - 1), "fewer"));
  }
  return "\n" + aligned(rows, 1);
}

/// What was measured of the nodes of a line.
std::string layouts_text(const Json& layouts) {
  if (layouts.empty()) return "";
  std::vector<Row> rows = {{"line_nodes"}, {"clocks"}, {"bytes a ray"}};
  for (const auto& [nodes, costs] : layouts.items()) {
    const Json& bytes = costs.at("bytes_per_ray");
    rows[0].push_back(nodes);
    rows[1].push_back(grouped(costs.at("clocks").get<std::uint64_t>()));
    rows[2].push_back(bytes.is_null() ? "-" : fmt::format("{:.2f}", bytes.get<double>()));
  }
  return "\n" + aligned(rows, 1);
}

}  // namespace

std::string specialise_page(const std::string& about, const CoreConfiguration& general,
                            const Json& result) {
  const Json& curves = result.at("curves");
  return fmt::format(
      "scene       {}\ncore        from {}, without the parts that the scene does not need\n\n"
      "{}\n{}{}{}{}\n",
      about, general.name, keys_text(general, result), costs_text(general, result.at("costs")),
      layouts_text(result.at("layouts")), curve_text("packets", curves.at("packets")),
      curve_text("lines", curves.at("lines")));
}

Json savings(const Json& general, const Json& special) {
  Json less = Json::object();
  for (const auto& [name, before] : general.items()) {
    const auto all = before.get<double>();
    if (all == 0 || !special.contains(name)) continue;
    less[name] = std::round(1000 * (1 - special.at(name).get<double>() / all)) / 10;
  }
  return less;
}

}  // namespace dynrt::host
