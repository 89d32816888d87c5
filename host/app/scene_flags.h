// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The flags that choose the view of a scene and its light, one row each: the commands take them
// from this table, and write them down from it where they name a frame again.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "host/app/arguments.h"

namespace dynrt::host {

struct SceneFlag {
  const char* name;
  std::variant<std::string SceneArguments::*, std::optional<std::string> SceneArguments::*,
               std::optional<double> SceneArguments::*, std::vector<std::string> SceneArguments::*>
      value;
  const char* text;   ///< what stands for the value in --help
  std::string about;  ///< in --help

  /// The values that are given, as the flag takes them.
  std::vector<std::string> given(const SceneArguments& scene) const;
};

std::span<const SceneFlag> scene_flags();
/// The name of the flag that has this value, e.g. --up.
std::string name_of(std::optional<std::string> SceneArguments::* value);

/// Adds them to a command, which writes their values to `scene`.
void add_scene_flags(CLI::App& command, SceneArguments& scene);

/// The flags that are given, each as NAME=VALUE.
std::vector<std::string> words_of(const SceneArguments& scene);

/// The flags of `dynrt needs` as JSON, for scripts/specialise, which takes them too: a list of
/// {"name", "value", "several", "of_frame"}, the text that stands for the value or nothing, whether
/// it may be given several times, and whether `dynrt render` has the flag, as it chooses a frame.
std::string listed_flags(const CLI::App& needs);

}  // namespace dynrt::host
