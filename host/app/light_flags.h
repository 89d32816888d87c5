// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// --light and --mirror: their values, and the configurations that have rays for them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/board/board.h"
#include "host/scene/scene.h"

namespace dynrt::host {

/// "1,2,3:1,0.5,0:40" as a light; throws UserError.
PointLight parse_light(const std::string& text, const std::string& name);

/// "chrome=0.5" as a name and a part of the light; throws UserError. A name may contain '=' if a
/// part follows.
std::pair<std::string, double> parse_mirror(const std::string& text);

/// The values of a command's flags.
struct LightOverrides {
  std::vector<PointLight> lights;
  std::vector<std::pair<std::string, double>> mirrors;

  /// Throws UserError for flags that cannot be read and for flags that the board has no rays for.
  /// Without a board it checks only the first.
  LightOverrides(const std::vector<std::string>& light, const std::vector<std::string>& mirror,
                 const CoreInfo* board);
  /// Throws UserError where the scene has no material of a name.
  void add_to(Scene& scene) const;
};

/// Throws UserError that names the configurations of this build with the rays that `flag` needs.
void require_reflections(const CoreInfo& board, const std::string& flag);

/// Sentences about lights and mirrors of the scene that the board has no rays for.
std::vector<std::string> unused_light(const Scene& scene, const CoreInfo& board);

}  // namespace dynrt::host
