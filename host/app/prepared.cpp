// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/prepared.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/app/text.h"
#include "host/layout/limits.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

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
  const TreeSize ends = address_ends(core());
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
           {{"position", json_of(space.outside(view.camera.position))},
            {"right", json_of(view.camera.right)},
            {"up", json_of(view.camera.up)},
            {"forward", json_of(view.camera.forward)}}},
          {"objects", objects_json},
          {"instance_tree", json_of("instances", trees.instances)},
          {"memory",
           {{"nodes", use.nodes},
            {"node_limit", ends.nodes},
            {"list_entries", use.list_entries},
            {"list_entry_limit", ends.items},
            {"matrices", use.matrices},
            {"matrix_limit", kMaxMatrices}}},
          {"load_seconds", load_seconds},
          {"tree_seconds", tree_seconds},
          {"trees_may_be_kept", trees_may_be_kept}};
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
      "\ntrees       {} nodes, {} list entries, {} levels of instances and {} of triangles, "
      "built {}in {:.2f} s\n",
      grouped(use.nodes), grouped(use.list_entries), trees.instances.stats.depth, deepest(trees),
      trees_may_be_kept ? "or taken from an earlier run " : "", tree_seconds);
  text += fmt::format("memory      {:.2f} MB of nodes and lists, {:.2f} MB of matrices\n",
                      use.tree_megabytes(), use.matrix_megabytes());
  text += fmt::format(
      "space       origin ({:g}, {:g}, {:g}), unit {:g}; the core's numbers still hold the scene "
      "if it is 2^{} times larger or 2^{} times smaller\n",
      space.centre.x, space.centre.y, space.centre.z, space.unit, headroom.up, headroom.down);
  for (const std::string& note : notes()) text += fmt::format("note        {}\n", note);
  return text;
}

std::vector<std::string> Prepared::notes() const {
  std::vector<std::string> all = scene.notes;
  all.insert(all.end(), trees.notes.begin(), trees.notes.end());
  return all;
}

void Prepared::note_no_hit() {
  const Box box = bounds(scene);
  const double aspect = static_cast<double>(view.width) / view.height;
  const Camera camera = host::frame(box, {0, 1, 0}, field_of_view_of(view.camera), aspect);
  const glm::dvec3 low = space.outside(box.low);
  const glm::dvec3 high = space.outside(box.high);
  const glm::dvec3 from = space.outside(camera.position);
  const glm::dvec3 to = (low + high) / 2.0;
  scene.notes.push_back(fmt::format(
      "no ray hits anything; the scene lies between ({:.4g}, {:.4g}, {:.4g}) and ({:.4g}, {:.4g}, "
      "{:.4g}), and this camera sees all of it: --position {:.4g},{:.4g},{:.4g} --look-at "
      "{:.4g},{:.4g},{:.4g}",
      low.x, low.y, low.z, high.x, high.y, high.z, from.x, from.y, from.z, to.x, to.y, to.z));
}

}  // namespace dynrt::host
