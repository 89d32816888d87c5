// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/prepare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "host/app/light_flags.h"
#include "host/app/messages.h"
#include "host/app/progress.h"
#include "host/app/text.h"
#include "host/board/configurations.h"
#include "host/image/form_trees.h"
#include "host/scene/load.h"
#include "host/specialise/tree_needs.h"
#include "host/specialise/within.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;
using Seconds = std::chrono::duration<double>;

Json json_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const std::string& name, const Tree& tree) {
  return {{"name", name},
          {"inner_nodes", tree.stats.inner_nodes},
          {"leaves", tree.stats.leaves},
          {"empty_children", tree.stats.empty_children},
          {"list_entries", tree.stats.items},
          {"longest_list", tree.stats.longest_list},
          {"depth", tree.stats.depth},
          {"cut", tree.cut},
          {"expected_steps", tree.stats.expected_steps},
          {"expected_leaves", tree.stats.expected_leaves},
          {"expected_items", tree.stats.expected_items}};
}

int deepest(const SceneTrees& trees) {
  int depth = 0;
  for (const Tree& tree : trees.objects) depth = std::max(depth, tree.stats.depth);
  return depth;
}

/// " (110 triangles of zero area, 3 points and lines left out)", or nothing.
std::string left_out(const ImportCounts& dropped) {
  std::vector<std::string> parts;
  if (dropped.zero_area_triangles > 0) {
    parts.push_back(counted(dropped.zero_area_triangles, "triangle") + " of zero area");
  }
  if (dropped.points_and_lines > 0) {
    const std::size_t count = dropped.points_and_lines;
    parts.push_back(grouped(count) + (count == 1 ? " point or line" : " points and lines"));
  }
  return parts.empty() ? "" : fmt::format(" ({} left out)", fmt::join(parts, ", "));
}

/// What the board's memory has left, whatever of it a core reaches.
TreeSize room_for_instances(const SceneTrees& trees) {
  TreeSize room = kMemoryForTrees;
  for (const Tree& tree : trees.objects) {
    room.nodes -= std::min(room.nodes, tree.size().nodes);
    room.items -= std::min(room.items, tree.size().items);
  }
  return room;
}

/// With trees so shallow that they never overflow the board's stacks, if those that there are
/// could.
TreeOptions options_for(const SceneTrees& trees, const BoardInfo& board) {
  TreeOptions options;
  const auto entries = [](unsigned depth) {
    return std::min(kMaxTreeDepth, static_cast<int>(depth));
  };
  for (const Tree& tree : trees.objects) {
    if (tree_needs(tree).pushes > entries(board.stack_depth)) {
      options.max_depth = entries(board.stack_depth);
    }
  }
  if (tree_needs(trees.instances).pushes > entries(board.top_stack_depth)) {
    options.max_top_depth = entries(board.top_stack_depth);
  }
  return options;
}

/// Throws UserError where the board's configuration lacks a primitive of the scene.
void check_primitives(const Scene& scene, const BoardInfo& board) {
  Primitives used;
  for (const Mesh& object : scene.objects) {
    used.triangle = used.triangle || !object.triangles.empty();
    used.rectangle = used.rectangle || !object.rectangles.empty();
    used.sphere = used.sphere || !object.ellipsoids.empty();
  }
  const auto lacks = [&](const Primitives& has) {
    return used.triangle && !has.triangle     ? "triangles"
           : used.sphere && !has.sphere       ? "spheres"
           : used.rectangle && !has.rectangle ? "rectangles"
                                              : nullptr;
  };
  if (const char* missing = lacks(board.primitives)) {
    const auto with = names_of(configurations(), [&](const Configuration& c) {
      return lacks(c.info().primitives) == nullptr;
    });
    refuse(messages::kNoPrimitive, board.configuration, missing, scene.name,
           fmt::format("{}", fmt::join(with, ", ")));
  }
}

/// Says of which objects a watertight core may lose a ray from far away.
void note_margins(Prepared& prepared, const ImageForm& form) {
  if (form.triangle_test != TriangleTest::kWatertight) return;
  const std::vector<std::string> names =
      beyond_margins(prepared.scene, prepared.camera.position, *form.format);
  if (names.empty()) return;
  const std::string others =
      names.size() == 1 ? "" : fmt::format(" and {} more", grouped(names.size() - 1));
  prepared.scene.notes.push_back(fmt::format(messages::kBeyondMargin, names.front(), others));
}

}  // namespace

ImageForm form_for(const BoardInfo& board) {
  return {board.format,       board.triangle_matrix, board.clips_to_cube, board.triangle_test,
          board.address_bits, board.matrix_bits,     board.one_colour,    board.levels};
}

CoreNumbers core_numbers(const BoardInfo& board, const Space& space) {
  return {std::ldexp(1.0, -static_cast<int>(board.format->mantissa_bits)), space};
}

Prepared prepare(const SceneArguments& arguments, unsigned width, unsigned height,
                 const BoardInfo* board) {
  // What a scene may exceed is told by check_within().
  std::optional<BoardInfo> origin;
  if (board != nullptr && !board->made_for.empty()) {
    origin = *board;
    if (board->made_from) {
      origin->lights = board->made_from->lights;
      origin->reflections = board->made_from->reflections;
      origin->primitives = board->made_from->primitives;
    }
  }
  const BoardInfo* allows = origin ? &*origin : board;
  const LightFlags light(arguments.lights, arguments.mirrors, allows);
  if (!arguments.mirrors.empty() && origin && board->reflections == 0) {
    refuse_excess({"reflections", "1", "0"}, *board, "--mirror " + arguments.mirrors.front());
  }
  const CameraFlags flags = arguments.camera();
  const auto begin = std::chrono::steady_clock::now();
  Scene scene;
  Camera camera;
  {
    const Progress progress("loading " + arguments.scene);
    scene = load_scene(arguments.scene);
    if (allows != nullptr) check_primitives(scene, *allows);
    camera = choose_camera(scene, flags, static_cast<int>(width), static_cast<int>(height));
    light.add_to(scene);
  }
  const auto loaded = std::chrono::steady_clock::now();
  Prepared prepared = prepare(std::move(scene), camera, width, height, board);
  prepared.load_seconds = Seconds(loaded - begin).count();
  return prepared;
}

Prepared prepare(Scene scene, const Camera& camera, unsigned width, unsigned height,
                 const BoardInfo* board) {
  const ImageForm form = board == nullptr ? ImageForm{} : form_for(*board);
  const bool made_for_one = board != nullptr && !board->made_for.empty();
  check_matrices(scene, made_for_one ? ImageForm{.triangles = form.triangles} : form);
  Prepared prepared;
  prepared.matrix = form.triangles;
  {
    const Fit fitted = fit(scene, camera, *form.format);
    move_into(fitted, scene);
    prepared.space = fitted.world;
    prepared.headroom = fitted.headroom;
    prepared.camera = moved_into(fitted.world, camera);
    prepared.scene = std::move(scene);
  }
  if (board != nullptr) {
    if (board->lights > 0) {
      check_lights(prepared.scene, prepared.camera.position, core_numbers(*board, prepared.space));
    }
    std::ranges::move(unused_light(prepared.scene, *board),
                      std::back_inserter(prepared.scene.notes));
  }
  note_margins(prepared, form);
  const auto begin = std::chrono::steady_clock::now();
  {
    const Progress progress("building the trees");
    const glm::dvec3& eye = prepared.camera.position;
    prepared.trees = trees_for(prepared.scene, eye, form);
    const BoardInfo* limits = made_for_one ? board->made_from.get() : board;
    if (limits != nullptr) {
      const TreeOptions options = options_for(prepared.trees, *limits);
      prepared.top_depth = options.max_top_depth;
      if (options.max_depth < kMaxTreeDepth || options.max_top_depth < kMaxTreeDepth) {
        prepared.trees = trees_for(prepared.scene, eye, form, options);
      }
    }
  }
  prepared.tree_seconds = Seconds(std::chrono::steady_clock::now() - begin).count();
  if (made_for_one) {
    check_within(needs_of(prepared), *board, fmt::format("the scene '{}'", prepared.scene.name));
  }
  prepared.objects = ObjectImage(prepared.scene, prepared.trees.objects, form);
  prepared.top_room =
      made_for_one ? room_for_instances(prepared.trees) : prepared.objects.room_left();
  prepared.frame = FrameImage(prepared.scene, prepared.objects, prepared.trees.instances,
                              prepared.camera, width, height);
  return prepared;
}

SceneNeeds needs_of(const Prepared& prepared) {
  return scene_needs(prepared.scene, prepared.trees, prepared.matrix);
}

std::size_t Prepared::triangles() const {
  std::size_t count = 0;
  for (const Mesh& object : scene.objects) count += object.triangles.size();
  return count;
}

std::size_t Prepared::rectangles() const {
  std::size_t count = 0;
  for (const Mesh& object : scene.objects) count += object.rectangles.size();
  return count;
}

std::size_t Prepared::spheres() const {
  std::size_t count = 0;
  for (const Mesh& object : scene.objects) count += object.ellipsoids.size();
  return count;
}

std::size_t Prepared::instanced_triangles() const {
  std::size_t count = 0;
  for (const Instance& instance : scene.instances) {
    count += scene.objects[instance.object].triangles.size();
  }
  return count;
}

Json Prepared::json() const {
  Json objects_json = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Json object = json_of(scene.objects[i].name, trees.objects[i]);
    object["triangles"] = scene.objects[i].triangles.size();
    object["rectangles"] = scene.objects[i].rectangles.size();
    object["spheres"] = scene.objects[i].ellipsoids.size();
    objects_json.push_back(std::move(object));
  }
  const Box box = bounds(scene);
  const MemoryUse use = memory_use(frame);
  return {{"name", scene.name},
          {"triangles", triangles()},
          {"rectangles", rectangles()},
          {"spheres", spheres()},
          {"instanced_triangles", instanced_triangles()},
          {"instances", scene.instances.size()},
          {"materials", scene.materials.size()},
          {"dropped_zero_area_triangles", scene.dropped.zero_area_triangles},
          {"dropped_points_and_lines", scene.dropped.points_and_lines},
          {"notes", notes()},
          {"low", json_of(space.outside(box.low))},
          {"high", json_of(space.outside(box.high))},
          {"space",
           {{"centre", json_of(space.centre)},
            {"unit", space.unit},
            {"headroom_up", headroom.up},
            {"headroom_down", headroom.down}}},
          {"camera",
           {{"position", json_of(space.outside(camera.position))},
            {"right", json_of(camera.right)},
            {"up", json_of(camera.up)},
            {"forward", json_of(camera.forward)}}},
          {"objects", objects_json},
          {"instance_tree", json_of("instances", trees.instances)},
          {"memory",
           {{"nodes", use.nodes},
            {"node_limit", kMaxNodes},
            {"list_entries", use.list_entries},
            {"list_entry_limit", kMaxListEntries},
            {"matrices", use.matrices},
            {"matrix_limit", kMaxMatrices}}},
          {"load_seconds", load_seconds},
          {"tree_seconds", tree_seconds}};
}

std::string Prepared::text() const {
  const MemoryUse use = memory_use(frame);
  std::string others;
  if (rectangles() > 0) others += ", " + counted(rectangles(), "rectangle");
  if (spheres() > 0) others += ", " + counted(spheres(), "sphere");
  std::string text = fmt::format(
      "scene       {}: {}{} in {}, {}", scene.name, counted(triangles(), "triangle"), others,
      counted(scene.objects.size(), "object"), counted(scene.instances.size(), "instance"));
  if (instanced_triangles() != triangles()) {
    text += fmt::format(", {} in all", counted(instanced_triangles(), "triangle"));
  }
  text += left_out(scene.dropped);
  text += fmt::format(
      "\ntrees       {} nodes, {} list entries, {} levels of instances and {} of triangles, built "
      "in "
      "{:.2f} s\n",
      grouped(use.nodes), grouped(use.list_entries), trees.instances.stats.depth, deepest(trees),
      tree_seconds);
  text += fmt::format("memory      {:.2f} MB of nodes and lists, {:.2f} MB of matrices\n",
                      use.tree_megabytes(), use.matrix_megabytes());
  text += fmt::format(
      "space       about ({:g}, {:g}, {:g}) in units of {:g}; the scene may grow by 2^{} and "
      "shrink "
      "by 2^{} until a number leaves the core's\n",
      space.centre.x, space.centre.y, space.centre.z, space.unit, headroom.up, headroom.down);
  for (const std::string& note : notes()) text += fmt::format("note        {}\n", note);
  return text;
}

std::vector<std::string> Prepared::notes() const {
  std::vector<std::string> all = scene.notes;
  all.insert(all.end(), trees.notes.begin(), trees.notes.end());
  return all;
}

}  // namespace dynrt::host
