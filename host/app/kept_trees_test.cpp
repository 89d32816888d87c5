// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/kept_trees.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <tuple>
#include <vector>

#include "host/test_folder.h"
#include "host/tree/test_meshes.h"
#include "host/tree/triangle_tree.h"

namespace dynrt::host {
namespace {

namespace fs = std::filesystem;

class Kept : public ::testing::Test {
 protected:
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    if (!fs::exists(folder_)) return found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path());
    return found;
  }

  const TestFolder whole_;
  const fs::path folder_ = whole_ / "trees";
  const Mesh object_ = testing::soup(1, 300, 0.2);
};

void expect_same(const Tree& a, const Tree& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    EXPECT_EQ(a.nodes[i].axis, b.nodes[i].axis);
    EXPECT_EQ(a.nodes[i].split, b.nodes[i].split);
    EXPECT_EQ(a.nodes[i].left, b.nodes[i].left);
    EXPECT_EQ(a.nodes[i].right, b.nodes[i].right);
  }
  EXPECT_EQ(a.items, b.items);
  EXPECT_EQ(a.root, b.root);
  EXPECT_EQ(a.clipped_root, b.clipped_root);
  EXPECT_EQ(a.main_leaf, b.main_leaf);
  EXPECT_EQ(a.box.low, b.box.low);
  EXPECT_EQ(a.box.high, b.box.high);
  EXPECT_EQ(a.cut, b.cut);
  EXPECT_EQ(a.given_up, b.given_up);
  EXPECT_EQ(a.leaves, b.leaves);
  const auto figures = [](const TreeStats& s) {
    return std::tuple(s.inner_nodes, s.leaves, s.leaf_links, s.empty_children, s.items,
                      s.longest_list, s.list_places, s.depth, s.expected_steps, s.expected_leaves,
                      s.expected_items);
  };
  EXPECT_EQ(figures(a.stats), figures(b.stats));
}

TEST_F(Kept, AreAsTheyWereBuilt) {
  const Tree built = build_triangle_tree(object_);
  const KeptTrees first(folder_);
  expect_same(first.tree(object_, {}), built);
  ASSERT_EQ(files().size(), 1u);
  const auto made = fs::last_write_time(files().front());
  expect_same(KeptTrees(folder_).tree(object_, {}), built);
  EXPECT_EQ(files().size(), 1u);
  EXPECT_EQ(fs::last_write_time(files().front()), made) << "it was built again";
}

TEST_F(Kept, AreOfOneObjectAndItsOptions) {
  const KeptTrees kept(folder_);
  kept.tree(object_, {});
  kept.tree(object_, {.patience = 2});
  kept.tree(object_, {.margin = 0.01});
  kept.tree(object_, {.leaves = Leaves::kPointers});
  Mesh moved = object_;
  moved.vertices.front().x += 1e-9;
  kept.tree(moved, {});
  EXPECT_EQ(files().size(), 5u);
  Mesh rounder = object_;
  rounder.rectangles.emplace_back();
  kept.tree(rounder, {});
  rounder.ellipsoids.emplace_back();
  kept.tree(rounder, {});
  rounder.ellipsoids.front().from_unit[3][0] = 0.5;
  kept.tree(rounder, {});
  EXPECT_EQ(files().size(), 8u);
  Mesh renamed = object_;
  renamed.name = "another name";
  kept.tree(renamed, {});
  EXPECT_EQ(files().size(), 8u);
}

TEST_F(Kept, AreBuiltAgainIfAFileIsDamaged) {
  const KeptTrees kept(folder_);
  const Tree built = kept.tree(object_, {});
  const fs::path file = files().at(0);
  const auto size = fs::file_size(file);
  for (const std::uintmax_t left : {std::uintmax_t{0}, std::uintmax_t{10}, size - 1}) {
    fs::resize_file(file, left);
    expect_same(kept.tree(object_, {}), built);
    EXPECT_EQ(fs::file_size(file), size) << "it is whole again";
  }
  std::fstream in(file, std::ios::binary | std::ios::in | std::ios::out);
  in.seekp(static_cast<std::streamoff>(size / 2));
  in.put('!');
  in.close();
  expect_same(kept.tree(object_, {}), built);
}

TEST_F(Kept, TakeNoMoreRoomThanTheyMay) {
  KeptTrees(folder_).tree(object_, {});
  const fs::path first = files().at(0);
  const std::uintmax_t one = fs::file_size(first);
  fs::last_write_time(first, fs::last_write_time(first) - std::chrono::hours(1));
  KeptTrees(folder_, 2 * one).tree(object_, {.patience = 2});
  EXPECT_TRUE(fs::exists(first));
  KeptTrees(folder_, 2 * one).tree(object_, {.patience = 1});
  EXPECT_FALSE(fs::exists(first));
  EXPECT_EQ(files().size(), 2u);
}

TEST_F(Kept, AreNotNeeded) {
  std::ofstream(folder_) << "a file where the folder should be";
  expect_same(KeptTrees(folder_).tree(object_, {}), build_triangle_tree(object_));
}

}  // namespace
}  // namespace dynrt::host
