// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The number of stages that the native model of the SDRAM controller must have.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace dynrt::verif {

/// The controller's stages, from the schedule that hlsc wrote.
inline unsigned stages_of(const std::string& schedule) {
  std::ifstream file(schedule);
  if (!file) throw std::runtime_error("cannot read the controller's schedule " + schedule);
  return nlohmann::json::parse(file).at("stages").get<unsigned>();
}

}  // namespace dynrt::verif
