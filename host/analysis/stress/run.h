// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs stress cases and writes their results as lines, as JSON or as the table of
// docs/results/stress.md.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "host/analysis/stress/case.h"

namespace dynrt::host::stress {

struct Result {
  const Case* stress = nullptr;
  Outcome outcome;
  Allowed allowed;
  std::string why;  ///< so much is allowed

  bool within() const { return stress::within(outcome, allowed); }
};

/// Runs a case. Throws BoardError if a board that it needs cannot be made. In a format other than
/// the shipped one the host may refuse a scene; the result then has its message. `frames`, if not
/// null, gets every rendered frame.
Result run_case(const Case& c, Boards& boards, std::vector<Frame>* frames = nullptr);

/// "ok  slivers/fan_1e4  32 needles ..: 257 rays, 257 hit; lost 1 (of 2 allowed)".
std::string line_of(const Result& result);
std::string summary_of(std::span<const Result> results, double seconds);
nlohmann::ordered_json json_of(std::span<const Result> results, const std::string& configuration,
                               const std::string& board, double seconds);
/// The cases as a table in Markdown, group by group.
std::string markdown_of(std::span<const Result> results);

/// Of the digests of all results, in their order.
std::uint64_t digest_of(std::span<const Result> results);

}  // namespace dynrt::host::stress
