// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/specialised.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "host/board/load_configuration.h"
#include "host/board/run_script.h"
#include "host/memory/matrix_numbers.h"
#include "host/scene/load.h"
#include "host/specialise/specialise_messages.h"

namespace dynrt::host {

namespace {

template <class Value>
void add(std::vector<std::string>& words, const char* flag, const std::optional<Value>& value) {
  if (value) words.push_back(fmt::format("{}={}", flag, *value));
}

std::vector<std::string> flags_of(const SceneArguments& scene) {
  std::vector<std::string> words = {"--size=" + scene.size};
  add(words, "--position", scene.position);
  add(words, "--look-at", scene.look_at);
  add(words, "--up", scene.up);
  add(words, "--fov", scene.field_of_view);
  for (const std::string& light : scene.lights) words.push_back("--light=" + light);
  for (const std::string& mirror : scene.mirrors) words.push_back("--mirror=" + mirror);
  return words;
}

}  // namespace

std::string general_configuration(const SceneArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  if (!arguments.lights.empty() || !arguments.mirrors.empty() || !scene.lights.empty() ||
      has_mirrors(scene)) {
    return "whitted";
  }
  const bool others = std::ranges::any_of(scene.objects, [](const Mesh& object) {
    return !object.rectangles.empty() || !object.ellipsoids.empty();
  });
  return others ? "primitives" : "thesis";
}

void SpecialiseFlags::add_to(CLI::App& command, bool may_exceed) {
  command_ = &command;
  command.add_flag("--specialise", specialise,
                   "use a core made for the scene, without the parts that the scene does not need; "
                   "--config names the general core to start from");
  if (may_exceed) {
    command.add_flag("--general-if-exceeded", general_if_exceeded,
                     "if the core was made for another scene or other frames and cannot hold this "
                     "one, render it on a general core instead of refusing it");
  }
}

ChosenCore SpecialiseFlags::choose(const SceneArguments& scene, const FrameArguments& frame,
                                   const std::vector<std::string>& more) const {
  const bool named = command_->get_option("--config")->count() > 0;
  if (!specialise) return {frame.configuration, general_of(frame.configuration)};
  const std::string general = named ? frame.configuration : general_configuration(scene);
  std::vector<std::string> words = flags_of(scene);
  words.push_back(scene.scene);
  words.push_back("--program=" + std::filesystem::read_symlink("/proc/self/exe").string());
  words.push_back("--config=" + general);
  add(words, "--reflections", frame.reflections);
  if (frame.uncompressed) words.emplace_back("--uncompressed");
  words.insert(words.end(), more.begin(), more.end());
  return {made_by_script("specialise", words, "--specialise"), general};
}

void SpecialiseFlags::refuse_unless_general(const Exceeded& over) const {
  if (!general_if_exceeded) throw Exceeded(fmt::format(messages::kOrOnGeneral, over.what()));
}

}  // namespace dynrt::host
