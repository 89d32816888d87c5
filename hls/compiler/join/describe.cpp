// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "join/emit_top.h"

namespace hlsc {
namespace {

std::string unit_of(const std::string& port) { return port.substr(0, port.find('.')); }

}  // namespace

std::string emit_json(const hls::JoinRecord& join, const std::string& name) {
  using Json = nlohmann::ordered_json;
  Json units = Json::array();
  for (const auto& unit : join.units) {
    units.push_back({{"name", unit.name}, {"module", unit.module}});
  }
  Json channels = Json::array();
  for (const auto& c : join.channels) {
    channels.push_back({{"name", c.name}, {"from", c.from}, {"to", c.to}, {"width", c.width}});
  }
  Json rams = Json::array();
  for (const auto& ram : join.rams) {
    rams.push_back({{"name", ram.name},
                    {"writer", ram.writer},
                    {"readers", ram.readers},
                    {"width", ram.width},
                    {"rows", ram.rows}});
  }
  const Json top = {{"module", name},
                    {"units", units},
                    {"channels", channels},
                    {"rams", rams},
                    {"counters", counter_names(join)}};
  return top.dump(2) + "\n";
}

std::string emit_diagram(const hls::JoinRecord& join) {
  std::string dot = "digraph core {\n  rankdir=LR;\n  node [shape=box, fontname=\"sans-serif\"];\n";
  const auto edge = [&dot](const std::string& from, const std::string& to, const std::string& label,
                           const char* style) {
    fmt::format_to(std::back_inserter(dot), "  \"{}\" -> \"{}\" [label=\"{}\", style={}];\n", from,
                   to, label, style);
  };
  for (const auto& unit : join.units) {
    fmt::format_to(std::back_inserter(dot), "  \"{}\";\n", unit.name);
  }
  for (const auto& c : join.channels) {
    for (const std::string& from : c.from) {
      for (const std::string& to : c.to) edge(unit_of(from), unit_of(to), c.name, "solid");
    }
  }
  for (const auto& ram : join.rams) {
    for (const std::string& to : ram.readers) {
      edge(unit_of(ram.writer), unit_of(to), ram.name, "dashed");
    }
  }
  for (const auto& bank : join.banks) {
    if (bank.write) {
      edge(unit_of(bank.port), bank.name, "", "bold");
    } else {
      edge(bank.name, unit_of(bank.port), "", "bold");
    }
  }
  return dot + "}\n";
}

}  // namespace hlsc
