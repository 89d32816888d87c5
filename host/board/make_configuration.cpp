// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs scripts/configuration.
#include <filesystem>
#include <string>
#include <vector>

#include "host/board/board_messages.h"
#include "host/board/load_configuration.h"
#include "host/board/run_script.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

/// What scripts/configuration makes with these flags.
std::string made_of(const std::string& json_path, std::vector<std::string> flags, const Tell& tell,
                    unsigned jobs) {
  std::error_code error;
  if (!std::filesystem::exists(json_path, error)) {
    refuse(messages::kNoConfigurationFile, json_path);
  }
  flags.insert(flags.begin(), json_path);
  if (tell) flags.emplace_back("--tell-steps");
  if (jobs > 0) flags.insert(flags.end(), {"--jobs", fmt::format("{}", jobs)});
  return made_by_script("configuration", flags, "configuration " + json_path, tell);
}

}  // namespace

std::string make_configuration(const std::string& json_path, bool rtl, const Tell& tell,
                               unsigned jobs) {
  return made_of(json_path, rtl ? std::vector<std::string>{"--rtl"} : std::vector<std::string>{},
                 tell, jobs);
}

std::string make_verilog(const std::string& json_path, const Tell& tell, unsigned jobs) {
  return made_of(json_path, {"--verilog"}, tell, jobs);
}

bool can_be_made(const std::string& json_path) {
  try {
    made_of(json_path, {"--check"}, {}, 0);
    return true;
  } catch (const UserError&) {
    return false;
  }
}

}  // namespace dynrt::host
