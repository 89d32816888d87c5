// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shared by the tests of the stress cases: boards, the names of tests, the golden digests.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "host/analysis/stress/run.h"
#include "host/board/configurations.h"

namespace dynrt::host::stress {

/// The configurations that every case is run on: one of each arithmetic (bounds.h).
inline const std::vector<std::string> kTested = {"thesis", "watertight", "fast", "fast_watertight"};

/// The row of a configuration in this build's table, or null. Where there is a row its board must
/// be made: a test that needs it skips only without one.
inline const Configuration* row_of(const std::string& configuration) {
  for (const Configuration& row : configurations()) {
    if (row.name == configuration) return &row;
  }
  return nullptr;
}

inline std::unique_ptr<Board> open_model(const std::string& configuration) {
  if (row_of(configuration) == nullptr) return nullptr;
  return make_board(configurations(), {"model", configuration, ""});
}

/// Configuration, and number of the case.
using Parameter = std::tuple<std::string, std::size_t>;

inline std::string name_of(const ::testing::TestParamInfo<Parameter>& info) {
  const auto& [configuration, number] = info.param;
  std::string name = configuration + "_" + cases()[number].full_name();
  for (char& c : name) {
    if (c == '-') c = 'm';
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

inline auto every_case() {
  return ::testing::Combine(::testing::ValuesIn(kTested),
                            ::testing::Range(std::size_t{0}, cases().size()));
}

inline const nlohmann::json& golden() {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(DYNRT_STRESS_GOLDEN), nullptr, true);
  return all;
}

}  // namespace dynrt::host::stress
