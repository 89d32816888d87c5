// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/light_flags.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <set>

#include "host/app/text.h"
#include "host/board/configurations.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

/// The names of this build's configurations that have some, after "--config ".
std::string with(unsigned CoreInfo::* some) {
  const auto names =
      names_of(configurations(), [&](const Configuration& c) { return c.core().*some > 0; });
  return names.empty() ? "no configuration of this build has them"
                       : fmt::format("take --config {}", fmt::join(names, " or --config "));
}

std::size_t mirrors_of(const Scene& scene) {
  return static_cast<std::size_t>(
      std::ranges::count_if(scene.materials, [](const Material& m) { return m.mirror > 0; }));
}

void set_mirror(Scene& scene, const std::string& material, double part) {
  std::set<std::string> names;
  for (Material& m : scene.materials) {
    if (m.name == material) m.mirror = part;
    names.insert(m.name);
  }
  if (!names.contains(material)) {
    refuse("scene '{}' has no material '{}'; its materials are {}", scene.name, material,
           fmt::format("{}", fmt::join(names, ", ")));
  }
}

void require_light_rays(const CoreInfo& board, const std::string& flag) {
  if (board.lights == 0) {
    refuse("{}: configuration {} has no light rays; {}", flag, board.name, with(&CoreInfo::lights));
  }
}

}  // namespace

PointLight parse_light(const std::string& text, const std::string& name) {
  const std::size_t colour = std::min(text.find(':'), text.size());
  const std::size_t intensity = std::min(text.find(':', colour + 1), text.size());
  PointLight light{name, parse_vector("--light", text.substr(0, colour)), glm::dvec3(1.0)};
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

std::pair<std::string, double> parse_mirror(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  double part = kMirrorShare;
  if (sign != text.npos && (!parse(text.substr(sign + 1), part) || !(part >= 0 && part <= 1))) {
    refuse("--mirror {}: write MATERIAL[=PART] with a part from 0 to 1, for example chrome=0.9",
           text);
  }
  return {text.substr(0, sign), part};
}

LightOverrides::LightOverrides(const std::vector<std::string>& light,
                               const std::vector<std::string>& mirror, const CoreInfo* board) {
  if (board && !light.empty()) require_light_rays(*board, "--light");
  if (board && !mirror.empty()) require_reflections(*board, "--mirror");
  for (const std::string& text : light) lights.push_back(parse_light(text, "--light " + text));
  for (const std::string& text : mirror) mirrors.push_back(parse_mirror(text));
}

void LightOverrides::add_to(Scene& scene) const {
  scene.lights.insert(scene.lights.end(), lights.begin(), lights.end());
  for (const auto& [material, part] : mirrors) set_mirror(scene, material, part);
}

void require_reflections(const CoreInfo& board, const std::string& flag) {
  if (board.reflections == 0) {
    refuse("{}: configuration {} has no reflected rays; {}", flag, board.name,
           with(&CoreInfo::reflections));
  }
}

std::vector<std::string> unused_light(const Scene& scene, const CoreInfo& board) {
  std::vector<std::string> notes;
  const std::size_t lights = scene.lights.size();
  if (lights > 0 && board.lights == 0) {
    notes.push_back(fmt::format(
        "the scene has {}, but configuration {} has no light rays and lights it from the eye; {}",
        counted(lights, "light"), board.name, with(&CoreInfo::lights)));
  } else if (lights > board.lights) {
    notes.push_back(
        fmt::format("the scene has {} lights, but configuration {} uses only the first {}", lights,
                    board.name, board.lights));
  }
  if (mirrors_of(scene) > 0 && board.reflections == 0) {
    notes.push_back(fmt::format("the scene has {}, but configuration {} has no reflected rays; {}",
                                counted(mirrors_of(scene), "mirror"), board.name,
                                with(&CoreInfo::reflections)));
  }
  return notes;
}

}  // namespace dynrt::host
