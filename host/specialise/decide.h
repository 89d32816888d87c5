// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What every key of a configuration (hls/configs/generate) must be for a scene, each with a
// sentence that says why. Keys that no scene decides, such as packets and lines, which are found by
// measuring, are left to scripts/specialise.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/board/board.h"
#include "host/specialise/scene_needs.h"

namespace dynrt::host {

struct Decision {
  std::string key;
  nlohmann::ordered_json value;
  std::string reason;  ///< a sentence without its full stop
};

/// What is asked of the frames, besides the scene.
struct FrameWishes {
  unsigned reflections = 0;  ///< bounces, at most
  bool uncompressed = false;
};

/// In the order of the configurations' keys. `general` is the core that renders the scene without
/// being made for it: of what that leaves out nothing is asked for.
std::vector<Decision> decide(const SceneNeeds& needs, const BoardInfo& general,
                             const FrameWishes& wishes);

nlohmann::ordered_json json_of(const std::vector<Decision>& decisions);
/// The figures that the decisions come from.
nlohmann::ordered_json json_of(const SceneNeeds& needs);

}  // namespace dynrt::host
