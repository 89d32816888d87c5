// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/tree_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "host/layout/core_trees.h"
#include "host/layout/lay_out.h"
#include "host/layout/test_scene.h"

namespace dynrt::host {
namespace {

using ::testing::ElementsAre;
using testing::two_objects;
using ::testing::UnorderedElementsAreArray;

CoreInfo core_with(unsigned line_nodes, Leaves leaves) {
  CoreInfo core = testing::test_core();
  core.line_nodes = line_nodes;
  core.datapath = leaves == Leaves::kPointers ? Datapath::kFast : Datapath::kThesis;
  return core;
}

/// A plane, or a leaf's items; -1 for an empty child.
using Visit = std::vector<double>;

/// What a ray that meets every cell finds below a pointer, left before right.
class Walk {
 public:
  Walk(const SceneMemory& memory, Leaves leaves) : memory_(memory), leaves_(leaves) {}

  void below(std::uint32_t pointer) {
    constexpr std::uint32_t kMark = 1u << (kAddressBits - 1);
    if (pointer == 0) return found.push_back({-1});
    if (leaves_ == Leaves::kPointers && (pointer & kMark) != 0) {
      return list((pointer & ~kMark) * kListStep);
    }
    const MemoryNode node = memory_.node(pointer);
    nodes.insert(pointer);
    if (node.kind == NodeKind::kLeaf) return list(node.left);
    found.push_back({static_cast<double>(node.kind), node.split});
    for (const std::uint32_t child : {node.left, node.right}) {
      if (child != 0 && (child & kMark) == 0) parent[child] = pointer;
      below(child);
    }
  }

  std::vector<Visit> found;
  std::set<std::uint32_t> nodes;
  std::map<std::uint32_t, std::uint32_t> parent;
  std::map<std::uint32_t, std::uint32_t> lists;  ///< entries by address

 private:
  void list(std::uint32_t address) {
    Visit items;
    for (bool last = false; !last; ++address) {
      const ListEntry entry = memory_.entry(address);
      items.push_back(static_cast<double>(entry.matrix.to_u64()));
      last = entry.last;
    }
    lists[address - static_cast<std::uint32_t>(items.size())] =
        static_cast<std::uint32_t>(items.size());
    found.push_back(std::move(items));
  }

  const SceneMemory& memory_;
  Leaves leaves_;
};

/// The whole memory of a scene.
struct Walked {
  MemoryImage image;
  SceneMemory memory;
  Walk objects, top;

  Walked(Scene scene, unsigned line_nodes, Leaves leaves)
      : image(lay_out(std::move(scene), {testing::camera_at({0.1, 0.2, 20}, {0, 0, -1}), 64, 48},
                      core_with(line_nodes, leaves))),
        objects(memory, leaves),
        top(memory, leaves) {
    memory.write(image.runs());
    for (const ObjectImage::Object& object : image.objects.objects) {
      objects.below(object.clipped_root);
    }
    top.below(image.frame.start_node);
  }
};

Scene large_scene() {
  Scene scene = two_objects();
  const std::vector<Instance> few = scene.instances;
  for (int row = 1; row < 40; ++row) {
    for (Instance instance : few) {
      instance.transform[3] += glm::dvec4(0, 2.1 * row, 0.3 * (row % 7), 0);
      scene.instances.push_back(instance);
    }
  }
  return scene;
}

struct Case {
  unsigned line_nodes;
  Leaves leaves;
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.line_nodes << (c.leaves == Leaves::kPointers ? " with pointers" : " with leaves");
}
class InLines : public ::testing::TestWithParam<Case> {};

TEST_P(InLines, ARayFindsTheSameTreesAndTheyTakeNoMorePlace) {
  const auto [line_nodes, leaves] = GetParam();
  const Walked plain(large_scene(), 1, leaves);
  const Walked lines(large_scene(), line_nodes, leaves);
  for (const auto level : {&Walked::objects, &Walked::top}) {
    EXPECT_EQ((lines.*level).found, (plain.*level).found);
    EXPECT_EQ((lines.*level).nodes, (plain.*level).nodes) << "they take other addresses together";
  }
  const MemoryUse use = memory_use(lines.image.frame), before = memory_use(plain.image.frame);
  EXPECT_EQ(use.nodes, before.nodes);
  EXPECT_LE(use.list_entries, before.list_entries + 1) << "one, where a list begins evenly";
  EXPECT_EQ(use.matrices, before.matrices);
}

/// Of the nodes, those that do not lie in the line of their parent: a tree of full treelets has
/// one in each line.
double lines_entered(const Walk& walk, unsigned line_nodes) {
  std::size_t entered = 0;
  for (const auto& [child, parent] : walk.parent) {
    entered += child / line_nodes != parent / line_nodes;
  }
  return static_cast<double>(entered) / static_cast<double>(walk.nodes.size());
}

TEST_P(InLines, MostChildrenLieInTheLineOfTheirParent) {
  const auto [line_nodes, leaves] = GetParam();
  const Walked plain(large_scene(), 1, leaves);
  const Walked lines(large_scene(), line_nodes, leaves);
  for (const auto level : {&Walked::objects, &Walked::top}) {
    const double entered = lines_entered(lines.*level, line_nodes);
    EXPECT_LT(entered, lines_entered(plain.*level, line_nodes));
    EXPECT_LT(entered, 1.3 / line_nodes + 0.1);
  }
}

TEST_P(InLines, FewListsLieAcrossMoreLinesThanTheyMust) {
  const auto [line_nodes, leaves] = GetParam();
  const Walked lines(large_scene(), line_nodes, leaves);
  const std::uint32_t line = 2 * line_nodes;
  const auto taken = [line](std::uint32_t entries) { return (entries + line - 1) / line; };
  for (const Walk* level : {&lines.objects, &lines.top}) {
    std::size_t across = 0;
    for (const auto& [address, entries] : level->lists) {
      across += taken(address % line + entries) > taken(entries);
    }
    EXPECT_LT(5 * across, level->lists.size());
  }
}

TEST_P(InLines, TheOrderHasEachNodeAndEachLeafOnce) {
  const auto [line_nodes, leaves] = GetParam();
  const CoreInfo core = core_with(line_nodes, leaves);
  const Tree tree = trees_for(two_objects(), glm::dvec3(0, 0, 9), core).objects[1];
  const MemoryOrder order = memory_order(tree, line_nodes, {0, 0});
  const MemoryOrder plain = memory_order(tree, 1, {0, 0});
  EXPECT_THAT(order.nodes, UnorderedElementsAreArray(plain.nodes));
  EXPECT_THAT(order.leaves, UnorderedElementsAreArray(plain.leaves));
}

INSTANTIATE_TEST_SUITE_P(Sizes, InLines,
                         ::testing::Values(Case{2, Leaves::kNodes}, Case{4, Leaves::kNodes},
                                           Case{2, Leaves::kPointers}, Case{4, Leaves::kPointers}));

TEST(MemoryOrder, OfOneNodeToALineIsTheTrees) {
  const Tree tree = trees_for(two_objects(), glm::dvec3(0, 0, 9), testing::test_core()).objects[0];
  const MemoryOrder order = memory_order(tree, 1, {5, 7});
  EXPECT_EQ(order.nodes.size(), tree.nodes.size() - 1);
  EXPECT_TRUE(std::ranges::is_sorted(order.nodes));
  EXPECT_TRUE(std::ranges::is_sorted(order.leaves));
  EXPECT_EQ(order.leaves.size(), tree.stats.leaves);
}

/// A root whose right child has most of the box, and that child too.
Tree lopsided() {
  Tree tree;
  tree.leaves = Leaves::kPointers;
  add_clipping_nodes(tree, {glm::dvec3(0), glm::dvec3(1)});
  tree.root = 7;
  tree.nodes.push_back({0, 0.0625, 8, 9});
  tree.nodes.push_back({1, 0.5, kNullNode, 12});
  tree.nodes.push_back({0, 0.25, 10, 11});
  tree.nodes.push_back({1, 0.5, 12, kNullNode});
  tree.nodes.push_back({2, 0.5, 12, 13});
  tree.nodes.push_back({kLeafAxis, 0, 0, 3});
  tree.nodes.push_back({kLeafAxis, 0, 3, 1});
  tree.items = {0, 1, 2, 3};
  return tree;
}

TEST(MemoryOrder, TheChildWithTheLargestSurfaceJoinsTheLine) {
  // All rays reach the clipping nodes, 1 to 6, and the root.
  EXPECT_THAT(memory_order(lopsided(), 2, {0, 0}).nodes,
              ElementsAre(1, 2, 3, 4, 5, 6, 7, 9, 11, 10, 8));
  EXPECT_THAT(memory_order(lopsided(), 4, {0, 0}).nodes,
              ElementsAre(1, 2, 3, 4, 5, 6, 7, 9, 11, 10, 8));
}

TEST(MemoryOrder, ASmallTreeletFillsTheRestOfALine) {
  // A place is left in the first line of two; of the treelets, 11 is the first that has one node.
  EXPECT_THAT(memory_order(lopsided(), 2, {1, 0}).nodes,
              ElementsAre(11, 1, 2, 3, 4, 5, 6, 7, 9, 10, 8));
}

TEST(MemoryOrder, AListThatFitsGoesFirst) {
  EXPECT_THAT(memory_order(lopsided(), 2, {0, 0}).leaves, ElementsAre(12, 13));
  EXPECT_THAT(memory_order(lopsided(), 2, {0, 2}).leaves, ElementsAre(13, 12));
}

TEST(MemoryOrder, TheListOfTheMainObjectIsThere) {
  Scene scene = two_objects();
  scene.instances.resize(2);
  scene.instances[0].transform = glm::scale(glm::dmat4(1), glm::dvec3(50));
  CoreInfo core = core_with(4, Leaves::kPointers);
  core.main_first = true;
  const MemoryImage image =
      lay_out(std::move(scene), {testing::camera_at({0.1, 0.2, 200}, {0, 0, -1}), 64, 48}, core);
  ASSERT_NE(image.trees.instances.main_leaf, kNullNode);
  SceneMemory memory;
  memory.write(image.runs());
  Walk walk(memory, Leaves::kPointers);
  walk.below(image.frame.start_node);
  const Visit main{static_cast<double>(image.frame.first_instance)};
  EXPECT_EQ(walk.found, std::vector<Visit>{main});
}

}  // namespace
}  // namespace dynrt::host
