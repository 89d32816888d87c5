// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/read_schedule.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/error.h"

namespace dynrt::host {

hls::ModuleSchedules read_schedule(const std::string& folder) {
  hls::ModuleSchedules schedule;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream file(entry.path());
    const auto json = nlohmann::json::parse(file, nullptr, false);
    try {
      if (!json.is_discarded() && !json.contains("stages")) continue;  // of something else
      hls::ModuleSchedule& module = schedule[json.at("module").get<std::string>()];
      module.stages = json.at("stages").get<unsigned>();
      module.room = json.at("room").get<unsigned>();
      module.ram_stages = json.at("ram_stages").get<std::map<std::string, unsigned>>();
    } catch (const nlohmann::json::exception&) {
      refuse("{}: not a complete schedule of hlsc; lower the unit again or remove the file",
             entry.path().string());
    }
  }
  if (schedule.empty()) {
    refuse(
        "{}: the folder has no schedules of hlsc; name the folder of a configuration's Verilog, "
        "such as build/release/generated/fast",
        folder);
  }
  return schedule;
}

}  // namespace dynrt::host
