// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/kept_trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <cereal/archives/binary.hpp>
#include <cereal/types/vector.hpp>
#include <fstream>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "host/app/cache.h"
#include "host/app/tree_sources.h"
#include "host/error.h"
#include "host/picture/output_file.h"
#include "host/tree/triangle_tree.h"

namespace glm {

template <class Archive>
void serialize(Archive& archive, dvec3& v) {
  archive(v.x, v.y, v.z);
}
template <class Archive>
void serialize(Archive& archive, uvec3& v) {
  archive(v.x, v.y, v.z);
}
template <class Archive>
void serialize(Archive& archive, dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    archive(m[column].x, m[column].y, m[column].z, m[column].w);
  }
}

}  // namespace glm

namespace dynrt::host {

namespace fs = std::filesystem;

template <class Archive>
void serialize(Archive& archive, TreeNode& node) {
  archive(node.axis, node.split, node.left, node.right);
}
template <class Archive>
void serialize(Archive& archive, Aabb& box) {
  archive(box.low, box.high);
}
template <class Archive>
void serialize(Archive& archive, TreeStats& s) {
  archive(s.inner_nodes, s.leaves, s.leaf_links, s.empty_children, s.items, s.longest_list,
          s.list_places, s.depth, s.expected_steps, s.expected_leaves, s.expected_items);
}
template <class Archive>
void serialize(Archive& archive, Tree& t) {
  archive(t.nodes, t.items, t.root, t.clipped_root, t.main_leaf, t.box, t.cut, t.given_up, t.leaves,
          t.stats);
}
template <class Archive>
void serialize(Archive& archive, Rectangle& r) {
  archive(r.corner, r.across, r.along);
}
template <class Archive>
void serialize(Archive& archive, Ellipsoid& e) {
  archive(e.from_unit);
}

namespace {

constexpr const char* kExtension = ".tree";

/// The object's name and materials make no difference to its tree.
std::string key_of(const Mesh& object, const TreeOptions& o) {
  std::ostringstream text;
  cereal::BinaryOutputArchive archive(text);
  archive(object.vertices, object.triangles, object.rectangles, object.ellipsoids);
  archive(o.grid.mantissa_bits(), o.grid.max_code(), o.leaves);
  archive(o.costs.step, o.costs.item, o.costs.empty_bonus, o.costs.hair, o.costs.hair_codes,
          o.costs.surface_rays, o.costs.surface_share);
  archive(o.depth_factor, o.depth_extra, o.max_depth, o.patience, o.sample_rays, o.give_up_items,
          o.margin, o.room.nodes, o.room.items);
  text << kTreeSources;
  return digest(text.str());
}

std::optional<Tree> read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  const std::string held(std::istreambuf_iterator<char>(file), {});
  const std::size_t checked = held.find('\n');
  if (checked == std::string::npos) return std::nullopt;
  const std::string bytes = held.substr(checked + 1);
  if (digest(bytes) != held.substr(0, checked)) return std::nullopt;
  std::istringstream in(bytes);
  Tree tree;
  try {
    cereal::BinaryInputArchive archive(in);
    archive(tree);
  } catch (const cereal::Exception&) {
    return std::nullopt;
  }
  return tree;
}

}  // namespace

Tree KeptTrees::tree(const Mesh& object, const TreeOptions& options) const {
  const fs::path file = folder_ / (key_of(object, options) + kExtension);
  if (std::optional<Tree> kept = read(file)) return *std::move(kept);
  Tree tree = build_triangle_tree(object, options);
  keep(file, tree);
  return tree;
}

void KeptTrees::keep(const fs::path& file, const Tree& tree) const {
  // Two objects of one shape have one file.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  std::ostringstream bytes;
  cereal::BinaryOutputArchive archive(bytes);
  archive(tree);
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (failed) return;
  try {
    write_text(file.string(), digest(bytes.str()) + "\n" + bytes.str());
    make_room();
  } catch (const UserError&) {
    return;  // the tree is there, and the next run builds it again
  }
}

void KeptTrees::make_room() const {
  struct File {
    fs::file_time_type made;
    std::uintmax_t bytes;
    fs::path path;
  };
  std::vector<File> files;
  std::uintmax_t sum = 0;
  std::error_code gone;  // another run may tidy up, too
  std::error_code end;
  fs::directory_iterator entry(folder_, end);
  for (; !end && entry != fs::directory_iterator(); entry.increment(end)) {
    if (entry->path().extension() != kExtension) continue;
    const std::uintmax_t bytes = entry->file_size(gone);
    if (gone) continue;
    files.push_back({entry->last_write_time(gone), bytes, entry->path()});
    sum += bytes;
  }
  std::ranges::sort(files, {}, &File::made);
  for (std::size_t i = 0; i < files.size() && sum > most_bytes_; ++i) {
    fs::remove(files[i].path, gone);
    sum -= files[i].bytes;
  }
}

fs::path folder_of_trees() {
  const fs::path cache = cache_folder();
  return cache.empty() ? cache : cache / "trees";
}

TreeOptions kept_trees() {
  const fs::path folder = folder_of_trees();
  if (folder.empty()) return {};
  return {.make = [kept = KeptTrees(folder)](const Mesh& object, const TreeOptions& options) {
    return kept.tree(object, options);
  }};
}

}  // namespace dynrt::host
