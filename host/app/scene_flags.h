// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The flags that choose the view of a scene and its light, one row each. A command reads them from
// this table into SceneArguments, and writes them down from it where it names a frame again.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/app/arguments.h"

namespace dynrt::host {

struct SceneFlag {
  const char* name;
  const char* text;   ///< what stands for the value in --help
  std::string about;  ///< in --help
  /// Takes a value as the user writes it; throws UserError.
  void (*read)(SceneArguments& scene, const std::string& text);
  bool several = false;  ///< can be given several times

  /// The values that are given, as the flag takes them.
  std::vector<std::string> given(const SceneArguments& scene) const;
};

std::span<const SceneFlag> scene_flags();

/// Adds them to a command, which writes their values to `scene`.
void add_scene_flags(CLI::App& command, SceneArguments& scene);

/// The flags that are given, each as NAME=VALUE.
std::vector<std::string> words_of(const SceneArguments& scene);

/// "1,2,3:1,0.5,0:40" as a light; throws UserError.
PointLight parse_light(const std::string& text);
/// "chrome=0.5" as a material and its part of the light; throws UserError. A name may contain '='
/// if a part follows.
Mirror parse_mirror(const std::string& text);

}  // namespace dynrt::host
