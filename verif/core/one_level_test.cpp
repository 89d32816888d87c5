// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cores of one level, for one object that lies in the world as it is: no ray ever enters an object,
// and the parts for it are missing. Hit records and pixels are those of two levels.
#include "configs/fast.h"
#include "configs/thesis.h"
#include "configs/whitted.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

using Thesis = config::thesis;

template <class General>
struct OneLevel : General {
  static constexpr unsigned kLevels = 1;
};
/// And everything else left out that `blocks` and `lamps` can do without.
template <class General>
struct Least : OneLevel<General> {
  static constexpr unsigned kStackDepth = 20;
  static constexpr unsigned kAddressBits = 15;
  static constexpr unsigned kMatrixBits = 13;
  static constexpr unsigned kTriangleSlots = 0;
  static constexpr bool kOneColour = true;
  static constexpr bool kUncompressed = false;
  static constexpr bool kCounters = false;
};

TEST(OneLevel, OneObjectTakesNoTreeAboveIt) {
  expect_as_general<OneLevel<Thesis>>("thesis", "blocks", merge);
  expect_as_general<OneLevel<Thesis>>("thesis", "office");
}

TEST(OneLevel, OfTheFastDatapathToo) {
  expect_as_general<OneLevel<config::fast>>("fast", "blocks", merge);
}

struct Split : config::whitted {
  static constexpr Crossing kCrossing = Crossing::kSplit;
};

TEST(OneLevel, LightAndReflectionsTakeOneLevelToo) {
  expect_as_general<OneLevel<config::whitted>>("whitted", "lamps", merge);
  expect_as<OneLevel<Split>>(*board_of<Split>("split"), "split", "lamps", merge);
}

TEST(OneLevel, AllElseMayBeLeftOutToo) {
  expect_as_general<Least<Thesis>>("thesis", "blocks", merge_and_paint);
  expect_as_general<Least<config::whitted>>("whitted", "lamps", merge_and_paint);
}

TEST(OneLevel, WhatEntersObjectsIsGone) {
  using One = OneLevel<Thesis>;
  EXPECT_TRUE(is_there(NodeFetch<Thesis>().object_done));
  EXPECT_FALSE(is_there(NodeFetch<One>().object_done));
  EXPECT_TRUE(is_there(PacketDecoder<Thesis>().enter_object));
  EXPECT_FALSE(is_there(PacketDecoder<One>().enter_object));
  EXPECT_TRUE(is_there(MatrixStore<Thesis>().object));
  EXPECT_FALSE(is_there(MatrixStore<One>().object));
  EXPECT_TRUE(is_there(CollectHits<Thesis>().object));
  EXPECT_FALSE(is_there(CollectHits<One>().object));
  EXPECT_TRUE(is_there(Mailbox<Thesis>().objects));
  EXPECT_FALSE(is_there(Mailbox<One>().objects));
  EXPECT_EQ(2 * kLevelRows<One>, kLevelRows<Thesis>);
  EXPECT_EQ(2 * kStackRows<One>, kStackRows<Thesis>);
  EXPECT_EQ((kSaved<dynrt::HitRecord<Thesis>, dynrt::HitRecord<One>>), kMatrixBits);
  EXPECT_EQ((kSaved<StepContext<Thesis>, StepContext<One>>), 1u);
  EXPECT_EQ((kSaved<JobRecord<One>, JobRecord<Least<Thesis>>>),
            24u + (kMatrixBits - Least<Thesis>::kMatrixBits));
  EXPECT_EQ(frame_words_of<One>({}).size(), frame_words_of<Thesis>({}).size() + 1);
}

TEST(OneLevel, TheInstanceTakesNoMemory) {
  const MemoryImage two = laid_out("blocks", core_info_of<Thesis>(), merge);
  const MemoryImage one = laid_out("blocks", core_info_of<OneLevel<Thesis>>(), merge);
  EXPECT_TRUE(one.frame.memory.nodes.empty());
  EXPECT_TRUE(one.frame.memory.entries.empty());
  EXPECT_EQ(one.frame.memory.columns.size(), 4u) << "the camera";
  EXPECT_EQ(two.frame.memory.columns.size(), 8u);
  EXPECT_EQ(one.frame.first_instance, two.frame.first_instance);
}

TEST(OneLevel, WhatTakesTwoIsRefused) {
  const CoreInfo board = core_info_of<OneLevel<Thesis>>();
  EXPECT_EQ(refusal([&] { laid_out("blocks", board); }),
            "scene 'blocks' has 10 instances, but the core's trees have one level and hold one "
            "object; take a configuration with levels 2");
  const auto turn = [](Scene& scene) {
    merge(scene);
    std::swap(scene.instances[0].transform[0], scene.instances[0].transform[1]);
  };
  EXPECT_EQ(refusal([&] { laid_out("blocks", board, turn); }),
            "scene 'blocks': instance 'all' moves, turns or scales its object, but the core's "
            "trees have one level and cannot move an object; take a configuration with levels 2");
}

}  // namespace
}  // namespace dynrt::host::specialised
