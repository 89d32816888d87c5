// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/scene_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "host/app/text.h"
#include "host/error.h"
#include "host/format/memory_format_of.h"
#include "units/memory_format.h"

namespace dynrt::host {

namespace {

/// Small enough that values computed from a flag stay within the shipped core's numbers. lay_out()
/// refuses values that another core cannot hold.
const double kLargest = std::sqrt(kShippedFormat.largest);

void read_size(SceneArguments& scene, const std::string& text) {
  std::array<unsigned, 2> size{};
  if (!parse_list(text, 'x', size))
    refuse("--size {}: write WIDTHxHEIGHT in pixels, for example 512x384", text);
  std::tie(scene.width, scene.height) = std::tie(size[0], size[1]);
}

/// "1,2.5,-3" as a vector; throws UserError that names the flag.
glm::dvec3 parse_vector(const char* flag, const std::string& text) {
  std::array<double, 3> numbers{};
  if (!parse_list(text, ',', numbers))
    refuse("{} {}: write three numbers separated by commas, for example 1,2.5,-3", flag, text);
  for (const double number : numbers) {
    if (!(std::abs(number) <= kLargest)) {
      refuse("{} {}: the numbers must lie within -{:.3g} and {:.3g}", flag, text, kLargest,
             kLargest);
    }
  }
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

PointLight parse_light(const std::string& text) {
  const std::size_t colour = std::min(text.find(':'), text.size());
  const std::size_t intensity = std::min(text.find(':', colour + 1), text.size());
  PointLight light{"--light " + text, parse_vector("--light", text.substr(0, colour)),
                   glm::dvec3(1.0)};
  if (colour < text.size()) {
    light.colour = parse_vector("--light", text.substr(colour + 1, intensity - colour - 1));
  }
  double factor = 1;
  if (intensity < text.size() && !parse(text.substr(intensity + 1), factor)) factor = 0;
  const bool bright = std::isfinite(factor) && factor > 0 &&
                      glm::all(glm::greaterThanEqual(light.colour, glm::dvec3(0.0))) &&
                      glm::any(glm::greaterThan(light.colour, glm::dvec3(0.0)));
  if (!bright) {
    refuse(
        "--light {}: write X,Y,Z[:R,G,B[:INTENSITY]] with a colour that is neither negative nor "
        "black, and an intensity above zero, for example 1,3,2:1,0.9,0.8:5",
        text);
  }
  light.colour *= factor;
  return light;
}

Mirror parse_mirror(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  Mirror mirror{text.substr(0, sign)};
  if (sign != text.npos &&
      (!parse(text.substr(sign + 1), mirror.part) || !(mirror.part >= 0 && mirror.part <= 1))) {
    refuse("--mirror {}: write MATERIAL[=PART] with a part from 0 to 1, for example chrome=0.9",
           text);
  }
  return mirror;
}

std::span<const SceneFlag> scene_flags() {
  using Scene = SceneArguments;
  using Text = std::string;
  static const SceneFlag kTable[] = {
      {"--size", "WxH [512x384]",
       fmt::format("pixels of the image, at most {} a side and {} in all", kMaxSide,
                   grouped(kMaxPixels)),
       read_size},
      {"--position", "X,Y,Z", "position of the camera; default: the scene's own",
       [](Scene& s, const Text& text) { s.camera.position = parse_vector("--position", text); }},
      {"--look-at", "X,Y,Z", "the point in the middle of the image",
       [](Scene& s, const Text& text) { s.camera.look_at = parse_vector("--look-at", text); }},
      {"--up", "X,Y,Z", "the direction that is up in the image",
       [](Scene& s, const Text& text) { s.camera.up = parse_vector("--up", text); }},
      {"--fov", "DEGREES", "vertical field of view",
       [](Scene& s, const Text& text) { parse(text, s.camera.field_of_view.emplace()); }},
      {"--light", "X,Y,Z[:R,G,B[:INTENSITY]]",
       "add a point light; by default its colour is white and its intensity 1; can be given "
       "several "
       "times",
       [](Scene& s, const Text& text) { s.lights.push_back(parse_light(text)); }, true},
      {"--mirror", "MATERIAL[=0..1]",
       fmt::format("let the materials of this name reflect this part of the light (default: {}); "
                   "can be given several times",
                   kMirrorShare),
       [](Scene& s, const Text& text) { s.mirrors.push_back(parse_mirror(text)); }, true},
  };
  return kTable;
}

std::vector<std::string> SceneFlag::given(const SceneArguments& scene) const {
  if (read == read_size) return {fmt::format("{}x{}", scene.width, scene.height)};
  const auto found = scene.given.find(name);
  return found == scene.given.end() ? std::vector<std::string>() : found->second;
}

void add_scene_flags(CLI::App& command, SceneArguments& scene) {
  for (const SceneFlag& flag : scene_flags()) {
    CLI::Option* option = command.add_option_function<std::vector<std::string>>(
        flag.name,
        [&flag, &scene](const std::vector<std::string>& values) {
          scene.given[flag.name] = values;
          for (const std::string& value : values) flag.read(scene, value);
        },
        flag.about);
    option->option_text(flag.text)->allow_extra_args(false);
    if (!flag.several) option->expected(1);
  }
  command.get_option("--fov")->check(not_a_number);
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

}  // namespace dynrt::host
