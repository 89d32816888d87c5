// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The ends of paths and their times, held against the Verilog and the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "backend.h"
#include "cosim/random_netlist.h"
#include "emit/example_unit.h"

namespace hlsc {
namespace {

using testing::Contains;
using Names = std::set<std::string>;

/// The example and random units.
std::vector<Lowered> lowered_units() {
  std::vector<Lowered> units{lower(example(), options())};
  for (std::uint32_t seed = 3000; seed < 3020; ++seed) {
    units.push_back(lower(random_netlist(seed), random_options(seed, DELAY_FOLDER)));
  }
  return units;
}

/// What the only group of a pattern finds.
Names found(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  Names names;
  for (std::sregex_iterator i(text.begin(), text.end(), regex); i != std::sregex_iterator(); ++i) {
    names.insert((*i)[1]);
  }
  return names;
}

Names registers(const std::string& verilog) {
  return found(verilog, "\n  reg +(?:\\[.*?\\] )?(\\w+);");
}

/// The ports that an instance is connected by.
Names instance_ports(const std::string& verilog, const std::string& instance) {
  const std::size_t begin = verilog.find(" " + instance + " (\n");
  if (begin == std::string::npos) return {};
  return found(verilog.substr(begin, verilog.find(';', begin) - begin), "\\.(\\w+)\\(");
}

Names ends_of(const Lowered& lowered) {
  const nlohmann::json timing = nlohmann::json::parse(lowered.timing);
  Names signals;
  for (const auto& end : timing["ends"]) signals.insert(end["signal"].get<std::string>());
  return signals;
}

TEST(TimingJson, NamesEndsAsTheVerilogDoes) {
  for (const Lowered& lowered : lowered_units()) {
    const Names ends = ends_of(lowered);
    EXPECT_GT(ends.size(), 5u);
    Names own = registers(lowered.verilog);
    own.merge(found(lowered.verilog, "\n  output wire (?:\\[.*?\\] )?(\\w+)"));
    for (const std::string& signal : ends) {
      const std::size_t dot = signal.find('.');
      if (dot == std::string::npos) {
        EXPECT_THAT(own, Contains(signal));
      } else {
        EXPECT_THAT(instance_ports(lowered.verilog, signal.substr(0, dot)),
                    Contains(signal.substr(dot + 1)))
            << signal;
      }
    }
  }
}

TEST(TimingJson, HasEveryRegisterOfTheVerilog) {
  for (const Lowered& lowered : lowered_units()) {
    const Names ends = ends_of(lowered);
    const Names constant =
        found(lowered.verilog, "\n  always @\\(posedge clk_i\\) (\\w+) <= \\d+'\\w+;");
    const Names all = registers(lowered.verilog);
    EXPECT_GT(all.size(), 5u);
    for (const std::string& name : all) {
      if (!constant.contains(name)) EXPECT_THAT(ends, Contains(name));
    }
  }
}

TEST(TimingJson, HasEveryPortOfFifosAndRams) {
  const Names ends = ends_of(lower(example(), options()));
  for (const char* signal :
       {"total_fifo.valid_i", "total_fifo.data_i", "alarm_fifo.valid_i", "totals_ram.read_en_i",
        "totals_ram.read_addr_i", "totals_ram.write_en_i", "totals_ram.write_addr_i",
        "totals_ram.write_data_i", "sums_file.read_addr_i", "sums_file.write_en_i",
        "sums_file.write_addr_i", "sums_file.write_data_i", "limit_en_o", "limit_addr_o",
        "last_en_o", "last_addr_o", "last_data_o", "sample_ready_o", "valid_s1"}) {
    EXPECT_THAT(ends, Contains(signal));
  }
}

TEST(TimingJson, TimesOneScheduleByOtherModels) {
  Options o = options();
  const Lowered before = lower(example(), o);
  o.time_by.push_back(o.delay);
  o.time_by.back().token_out += 0.5;
  o.time_by.back().name = "slow tokens";
  const Lowered lowered = lower(example(), o);
  EXPECT_EQ(lowered.verilog, before.verilog);
  EXPECT_EQ(lowered.report, before.report);
  const nlohmann::json timing = nlohmann::json::parse(lowered.timing);
  EXPECT_EQ(timing["models"], nlohmann::json({"Lattice ECP5, speed grade 6", "slow tokens"}));
  for (const auto& end : timing["ends"]) {
    const bool data = end["signal"] == "total_fifo.data_i" || end["signal"] == "alarm_fifo.data_i";
    EXPECT_NEAR(end["ns"][1].get<double>() - end["ns"][0].get<double>(), data ? 0.5 : 0, 1e-6)
        << end["signal"];
  }
}

TEST(TimingJson, IsLongestWhereTheReportIs) {
  const Names unreported{"valid", "ready", "delay", "still"};
  for (const Lowered& lowered : lowered_units()) {
    const nlohmann::json timing = nlohmann::json::parse(lowered.timing);
    double longest = 0;
    for (const auto& end : timing["ends"]) {
      if (unreported.contains(end["kind"].get<std::string>())) continue;
      longest = std::max(longest, end["ns"][0].get<double>());
    }
    double reported = 0;
    for (const std::string& ns : found(lowered.report, "\n +\\d+ +\\d+ +([\\d.]+)")) {
      reported = std::max(reported, std::stod(ns));
    }
    EXPECT_NEAR(longest, reported, 0.0051) << timing["module"];
  }
}

}  // namespace
}  // namespace hlsc
