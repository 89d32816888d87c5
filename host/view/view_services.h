// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The services that the program gives to the window: scenes from its flags, boards of its
// configurations, the clock of a core. The window itself knows no flag.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/board/board.h"
#include "host/layout/lay_out.h"
#include "host/scene/camera.h"

namespace dynrt::host {

/// The reader's choices that decide the core and the scene in its memory.
struct ViewChoices {
  std::string configuration;
  std::vector<std::string> lights{}, mirrors{};  ///< beside the scene's own, as the flags take them
  std::optional<unsigned> mantissa_bits{};       ///< in place of the configuration's
  std::optional<unsigned> packets{}, lines{}, reflections{};
  friend bool operator==(const ViewChoices&, const ViewChoices&) = default;
};

enum class ViewBoard : std::uint8_t {
  kModel,
  kClocked,  ///< the model with its units' schedules, if they are there
  kRtl,
};

struct ViewServices {
  std::string scene;  ///< as the user named it
  ViewChoices choices;
  unsigned width = 512, height = 384;
  CameraOverrides camera;  ///< given by the user
  /// Builds the configuration if it is not built, and tells how far it is. Any thread may call it.
  std::function<void(const ViewChoices&, const std::function<void(const std::string&)>& tell)> make;
  /// A board of a configuration, which is built first if need be. Any thread may call it.
  std::function<std::unique_ptr<Board>(ViewBoard kind, const ViewChoices&)> board;
  /// The folder with the schedules of a configuration's units; empty if they are not there. Any
  /// thread may call it.
  std::function<std::string(const ViewChoices&)> schedules;
  /// Lowers the units of a configuration, which makes their schedules, and tells how far it is. Any
  /// thread may call it.
  std::function<void(const ViewChoices&, const std::function<void(const std::string&)>& tell)>
      lower;
  /// The scene in the memory of a core, with the lights and mirrors of the choices.
  std::function<MemoryImage(const ViewChoices&, const CoreInfo&)> prepare;
  /// The configurations to choose from, and the figures of the error reports.
  nlohmann::ordered_json offers;
  /// The clock of a core: {"mhz": ..} and where it comes from.
  std::function<nlohmann::ordered_json(const CoreInfo&)> clock;
};

}  // namespace dynrt::host
