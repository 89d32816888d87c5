// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Frames of the core SDRAM_CORE, whose keys stand in the list of configurations SDRAM_CORES.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "host/format/configuration_json.h"
#include "sdram/sdram_frames.h"
#include SDRAM_CORE_HEADER

namespace dynrt::verif {

namespace {

using C = config::SDRAM_CORE;

host::CoreInfo info() {
  std::ifstream file(SDRAM_CORES);
  for (const Json& keys : Json::parse(file)) {
    if (keys.at("name") == SDRAM_CORE_NAME) return host::core_info_of<C>(configuration_of(keys));
  }
  throw std::logic_error(SDRAM_CORES " does not list " SDRAM_CORE_NAME);
}

template <class S>
SdramFrame with(const SdramRequest& request, const std::string& controller) {
  const std::string file = fmt::format("{}/{}/sdram_controller.json", GENERATED, controller);
  const SdramSystem system{.core_nanoseconds = request.core_nanoseconds,
                           .display_bytes = request.display ? kDisplayed<C> : 0};
  return sdram_frame<C, S>(info(), request.scene, request.options, system,
                           {request.schedules, file});
}

}  // namespace

SdramFrame frame_of(const SdramRequest& request) {
  return request.mhz == 133 ? with<Sdram133>(request, "sdram_133")
                            : with<Sdram100>(request, "sdram");
}

}  // namespace dynrt::verif
