// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/scene_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "host/app/text.h"
#include "host/scene/scene.h"
#include "units/memory_format.h"

namespace dynrt::host {

std::span<const SceneFlag> scene_flags() {
  static const SceneFlag kTable[] = {
      {"--size", &SceneArguments::size, "WxH [512x384]",
       fmt::format("pixels of the image, at most {} a side and {} in all", kMaxSide,
                   grouped(kMaxPixels))},
      {"--position", &SceneArguments::position, "X,Y,Z",
       "position of the camera; default: the scene's own"},
      {"--look-at", &SceneArguments::look_at, "X,Y,Z", "the point in the middle of the image"},
      {"--up", &SceneArguments::up, "X,Y,Z", "the direction that is up in the image"},
      {"--fov", &SceneArguments::field_of_view, "DEGREES", "vertical field of view"},
      {"--light", &SceneArguments::lights, "X,Y,Z[:R,G,B[:INTENSITY]]",
       "add a point light; by default its colour is white and its intensity 1; can be given "
       "several "
       "times"},
      {"--mirror", &SceneArguments::mirrors, "MATERIAL[=0..1]",
       fmt::format("let the materials of this name reflect this part of the light (default: {}); "
                   "can be given several times",
                   kMirrorShare)},
  };
  return kTable;
}

std::string name_of(std::optional<std::string> SceneArguments::* value) {
  return std::ranges::find(scene_flags(), decltype(SceneFlag::value)(value), &SceneFlag::value)
      ->name;
}

std::vector<std::string> SceneFlag::given(const SceneArguments& scene) const {
  return std::visit(
      [&](auto member) -> std::vector<std::string> {
        const auto& held = scene.*member;
        using Held = std::remove_cvref_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::string>) {
          return {held};
        } else if constexpr (std::is_same_v<Held, std::vector<std::string>>) {
          return held;
        } else {
          if (!held) return {};
          return {fmt::format("{}", *held)};
        }
      },
      value);
}

void add_scene_flags(CLI::App& command, SceneArguments& scene) {
  for (const SceneFlag& flag : scene_flags()) {
    std::visit(
        [&](auto member) {
          auto& held = scene.*member;
          using Held = std::remove_cvref_t<decltype(held)>;
          CLI::Option* option = command.add_option(flag.name, held, flag.about);
          option->option_text(flag.text);
          if constexpr (std::is_same_v<Held, std::vector<std::string>>) {
            option->allow_extra_args(false);
          } else if constexpr (std::is_same_v<Held, std::optional<double>>) {
            option->check(not_a_number);
          }
        },
        flag.value);
  }
}

std::vector<std::string> words_of(const SceneArguments& scene) {
  std::vector<std::string> words;
  for (const SceneFlag& flag : scene_flags()) {
    for (const std::string& value : flag.given(scene)) {
      words.push_back(fmt::format("{}={}", flag.name, value));
    }
  }
  return words;
}

std::string listed_flags(const CLI::App& needs) {
  const CLI::App& render = *needs.get_parent()->get_subcommand("render");
  nlohmann::ordered_json flags = nlohmann::ordered_json::array();
  for (const CLI::Option* option : needs.get_options()) {
    const bool hidden = option->get_group().empty();
    if (hidden || option->get_positional() || option == needs.get_help_ptr()) continue;
    const std::string name = option->get_name();
    flags.push_back({{"name", name},
                     {"value", option->get_option_text()},
                     {"several", option->get_items_expected_max() > 1},
                     {"of_frame", render.get_option_no_throw(name) != nullptr}});
  }
  return flags.dump(2);
}

}  // namespace dynrt::host
