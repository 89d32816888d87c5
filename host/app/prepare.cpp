// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/prepare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "host/app/progress.h"
#include "host/app/text.h"
#include "host/board/configurations.h"
#include "host/error.h"
#include "host/layout/limits.h"
#include "host/specialise/within.h"

namespace dynrt::host {

namespace {

/// The names of this build's configurations that have some, after "--config ".
std::string with(unsigned CoreInfo::* some) {
  const auto names =
      names_of(configurations(), [&](const Configuration& c) { return c.core().*some > 0; });
  return names.empty() ? "no configuration of this build has them"
                       : fmt::format("take --config {}", fmt::join(names, " or --config "));
}

/// The core of which the user may ask for rays and primitives. For a specialised core it is the
/// general one, as lay_out() checks the limits of the specialised core.
CoreInfo asked_of(const CoreInfo& core) {
  CoreInfo asked = core;
  if (core.is_specialised() && core.general) {
    asked.lights = core.general->lights;
    asked.reflections = core.general->reflections;
    asked.primitives = core.general->primitives;
  }
  return asked;
}

/// The flags, where `asked` has rays for them.
void check_light(const SceneArguments& flags, const CoreInfo& asked, const CoreInfo& core) {
  if (!flags.lights.empty() && asked.lights == 0) {
    refuse("--light: configuration {} has no light rays; {}", asked.name, with(&CoreInfo::lights));
  }
  if (flags.mirrors.empty()) return;
  require_reflections(asked, "--mirror");
  if (core.is_specialised() && core.reflections == 0) {
    refuse_excess({"reflections", "1", "0"}, core, "--mirror " + flags.mirrors.front().material);
  }
}

/// The configurations that have all primitives of the scene.
std::string with_primitives_of(const Scene& scene) {
  const auto with = names_of(configurations(), [&](const Configuration& c) {
    return missing_primitive(scene, c.core()) == nullptr;
  });
  return fmt::format("{}", fmt::join(with, " or "));
}

void set_mirror(Scene& scene, const Mirror& mirror) {
  std::set<std::string> names;
  for (Material& material : scene.materials) {
    if (material.name == mirror.material) material.mirror = mirror.part;
    names.insert(material.name);
  }
  if (names.contains(mirror.material)) return;
  refuse("scene '{}' has no material '{}'; its materials are {}", scene.name, mirror.material,
         fmt::format("{}", fmt::join(names, ", ")));
}

void note_unused_light(Scene& scene, const CoreInfo& core) {
  const std::size_t lights = scene.lights.size();
  if (lights > 0 && core.lights == 0) {
    scene.notes.push_back(fmt::format(
        "the scene has {}, but configuration {} has no light rays and lights it from the eye; {}",
        counted(lights, "light"), core.name, with(&CoreInfo::lights)));
  } else if (lights > core.lights) {
    scene.notes.push_back(
        fmt::format("the scene has {} lights, but configuration {} uses only the first {}", lights,
                    core.name, core.lights));
  }
  const auto mirrors =
      std::ranges::count_if(scene.materials, [](const Material& m) { return m.mirror > 0; });
  if (mirrors > 0 && core.reflections == 0) {
    scene.notes.push_back(
        fmt::format("the scene has {}, but configuration {} has no reflected rays; {}",
                    counted(static_cast<std::uint64_t>(mirrors), "mirror"), core.name,
                    with(&CoreInfo::reflections)));
  }
}

/// The core for figures of a scene without a board: the shipped number format, every primitive and
/// stacks for every tree.
CoreInfo any_core() {
  CoreInfo core;
  core.stack_depth = kMaxTreeDepth;
  core.primitives = {.triangle = true, .sphere = true, .rectangle = true};
  return core;
}

}  // namespace

void require_reflections(const CoreInfo& core, const std::string& flag) {
  if (core.reflections > 0) return;
  refuse("{}: configuration {} has no reflected rays; {}", flag, core.name,
         with(&CoreInfo::reflections));
}

Prepared prepare(SceneFile& file, const CoreInfo* core, const TreeOptions& trees) {
  const SceneArguments& flags = file.arguments();
  const auto asked = core == nullptr ? std::nullopt : std::optional(asked_of(*core));
  if (asked) check_light(flags, *asked, *core);
  Scene scene = file.take();
  if (asked) check_primitives(scene, *asked, with_primitives_of(scene));
  View view{.width = flags.width, .height = flags.height};
  view.camera = choose_camera(scene, flags.camera, static_cast<int>(flags.width),
                              static_cast<int>(flags.height));
  scene.lights.insert(scene.lights.end(), flags.lights.begin(), flags.lights.end());
  for (const Mirror& mirror : flags.mirrors) set_mirror(scene, mirror);
  if (core != nullptr) note_unused_light(scene, *core);
  const Progress progress("building the trees");
  Prepared prepared(
      lay_out(std::move(scene), view, core == nullptr ? any_core() : *core, {.trees = trees}));
  prepared.load_seconds = file.seconds();
  prepared.trees_may_be_kept = trees.make != nullptr;
  return prepared;
}

Prepared prepare(const SceneArguments& arguments, const CoreInfo* core, const TreeOptions& trees) {
  SceneFile file(arguments);
  return prepare(file, core, trees);
}

}  // namespace dynrt::host
