// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/lay_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "host/error.h"
#include "host/format/configuration_json.h"
#include "host/layout/limits.h"
#include "host/specialise/tree_needs.h"

namespace dynrt::host {

namespace {

/// With trees so shallow that they never overflow the core's stacks, if those that there are could.
TreeOptions spared(TreeOptions options, const SceneTrees& trees, const CoreConfiguration& core) {
  const auto entries = [](unsigned depth) {
    return std::min(kMaxTreeDepth, static_cast<int>(depth));
  };
  for (const Tree& tree : trees.objects) {
    if (tree_needs(tree).pushes > entries(core.stack_depth)) {
      options.max_depth = entries(core.stack_depth);
    }
  }
  if (tree_needs(trees.instances).pushes > entries(core.stack_depth)) {
    options.max_top_depth = entries(core.stack_depth);
  }
  return options;
}

/// Names the objects at which a watertight core may lose a ray from far away.
void note_margins(MemoryImage& image) {
  if (!image.core().is_watertight()) return;
  const std::vector<std::string> names =
      beyond_margins(image.scene, image.view.camera.position, *image.core().format);
  if (names.empty()) return;
  const std::string others = names.size() == 1 ? "" : fmt::format(" and {} more", names.size() - 1);
  image.scene.notes.push_back(fmt::format(
      "object '{}'{} is small for the scene: a ray that starts many times its size away may miss "
      "it at an edge that lies in a plane of its tree, although the watertight test would hit it",
      names.front(), others));
}

/// For a specialised core check_within() has better messages, so here it only needs to fit the
/// memory.
void check_before(const Scene& scene, const CoreInfo& core) {
  if (core.is_specialised()) {
    CoreInfo whole = core;
    whole.levels = 2;
    whole.matrix_bits = kMatrixBits;
    check_matrices(scene, whole);
    return;
  }
  check_primitives(scene, core);
  check_matrices(scene, core);
}

void place(MemoryImage& image, Scene scene, const View& view, const LayoutOptions& options) {
  image.view = view;
  if (options.fit) {
    const Fit fitted = fit(scene, view.camera, *image.core().format);
    move_into(fitted, scene);
    image.space = fitted.world;
    image.headroom = fitted.headroom;
    image.view.camera = moved_into(fitted.world, view.camera);
  }
  image.scene = std::move(scene);
}

void build_trees(MemoryImage& image, const LayoutOptions& options) {
  if (options.built) {
    image.trees = *options.built;
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  const glm::dvec3& eye = image.view.camera.position;
  image.trees = trees_for(image.scene, eye, image.core(), options.trees);
  // A specialised core has the stacks that the trees of its general core ask for.
  const CoreConfiguration* stacks =
      image.core().is_specialised() ? image.core().general.get() : &image.core();
  if (options.spare_stacks && stacks != nullptr) {
    const TreeOptions shallow = spared(options.trees, image.trees, *stacks);
    image.top_depth = shallow.max_top_depth;
    if (shallow.max_depth < kMaxTreeDepth || shallow.max_top_depth < kMaxTreeDepth) {
      image.trees = trees_for(image.scene, eye, image.core(), shallow);
    }
  }
  image.tree_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

MemoryImage lay_out(Scene scene, const View& view, const CoreInfo& core,
                    const LayoutOptions& options) {
  check_before(scene, core);
  MemoryImage image(core);
  place(image, std::move(scene), view, options);
  if (core.lights > 0 && options.fit) {
    check_lights(image.scene, image.view.camera.position, core_numbers(core, image.space));
  }
  note_margins(image);
  build_trees(image, options);
  if (core.is_specialised()) {
    check_within(image.needs(), core, fmt::format("the scene '{}'", image.scene.name));
  }
  image.objects = ObjectImage(image.scene, image.trees.objects, core);
  image.top_room = image.objects.room_left();
  if (options.instances && !options.built) {
    BoxTreeOptions instances = *options.instances;
    instances.grid = Grid(*core.format);
    instances.leaves = leaves_of(core);
    instances.main_first = core.main_first;
    image.trees.instances = build_instance_tree(image.scene, image.objects.boxes(), instances);
  }
  image.frame = frame_of(image, image.trees.instances, image.view.camera);
  return image;
}

void check_laid_out_for(const MemoryImage& image, const CoreInfo& core) {
  for_each_key(core, [&](const ConfigurationKey& key, const auto&) {
    if (!key.of_core || !key.in_memory) return;
    const Json laid = value_of(image.core(), key.name);
    const Json has = value_of(core, key.name);
    if (laid == has) return;
    refuse(
        "scene '{}' is laid out for a core with {} {}, and configuration {} has {}; lay it out for "
        "the core that renders it",
        image.scene.name, key.name, laid.dump(), core.name, has.dump());
  });
}

std::vector<MemoryRun> MemoryImage::runs() const {
  std::vector<MemoryRun> runs = objects.memory.runs();
  std::ranges::move(frame.memory.runs(), std::back_inserter(runs));
  return runs;
}

SceneNeeds MemoryImage::needs() const {
  return scene_needs(scene, trees, core().triangle_matrix, boxes_of_instance(scene, core()));
}

Tree instances_of(const MemoryImage& image) {
  return build_instance_tree(image.scene, image.objects.boxes(),
                             {.grid = Grid(*image.core().format),
                              .leaves = leaves_of(image.core()),
                              .main_first = image.core().main_first,
                              .item = object_cost(image.core()),
                              .max_depth = image.top_depth,
                              .room = image.top_room});
}

std::optional<Excess> excess_of_frame(const MemoryImage& image, const SceneNeeds& needs,
                                      const Tree& instances) {
  if (!image.core().is_specialised()) return std::nullopt;
  return excess(frame_needs(needs, image.scene, instances), image.core());
}

FrameImage frame_of(const MemoryImage& image, const Tree& instances, const Camera& camera) {
  return {image.scene, image.objects, instances, camera, image.view.width, image.view.height};
}

CoreNumbers core_numbers(const CoreInfo& core, const Space& space) {
  return {std::ldexp(1.0, -static_cast<int>(core.format->mantissa_bits)), space};
}

}  // namespace dynrt::host
