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

using Tell = std::function<void(const std::string& step)>;

/// What scripts/configuration makes with these flags.
std::string made_of(const std::string& json_path, std::vector<std::string> flags,
                    const Tell& tell) {
  std::error_code error;
  if (!std::filesystem::exists(json_path, error)) {
    refuse(messages::kNoConfigurationFile, json_path);
  }
  flags.insert(flags.begin(), json_path);
  Answer answer;
  if (tell) {
    flags.emplace_back("--tell-steps");
    answer = [&tell](const std::string& step) {
      tell(step);
      return std::string();
    };
  }
  return made_by_script("configuration", flags, "configuration " + json_path, answer);
}

}  // namespace

std::string make_configuration(const std::string& json_path, bool rtl, const Tell& tell) {
  return made_of(json_path, rtl ? std::vector<std::string>{"--rtl"} : std::vector<std::string>{},
                 tell);
}

std::string make_verilog(const std::string& json_path, const Tell& tell) {
  return made_of(json_path, {"--verilog"}, tell);
}

}  // namespace dynrt::host
