// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs scripts/configuration.
#include <filesystem>

#include "host/board/board_messages.h"
#include "host/board/load_configuration.h"
#include "host/board/run_script.h"
#include "host/error.h"

namespace dynrt::host {

std::string make_configuration(const std::string& json_path, bool rtl,
                               const std::function<void(const std::string&)>& tell) {
  std::error_code error;
  if (!std::filesystem::exists(json_path, error)) {
    refuse(messages::kNoConfigurationFile, json_path);
  }
  std::vector<std::string> arguments = {json_path};
  if (rtl) arguments.emplace_back("--rtl");
  Answer answer;
  if (tell) {
    arguments.emplace_back("--tell-steps");
    answer = [&tell](const std::string& step) {
      tell(step);
      return std::string();
    };
  }
  return made_by_script("configuration", arguments, "configuration " + json_path, answer);
}

}  // namespace dynrt::host
