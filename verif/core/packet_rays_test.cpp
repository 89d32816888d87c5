// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Packets of eight and of sixteen rays: every ray has the hit and the pixel that it has among four,
// whichever rays travel with it, and the image's edges may cut a packet anywhere.
#include <algorithm>

#include "configs/thesis.h"
#include "configs/watertight.h"
#include "configs/whitted.h"
#include "configs/whitted_split.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

template <class General, unsigned Rays>
struct Packets : General {
  static constexpr unsigned kPacketRays = Rays;
};

/// Only rays that are in a leaf meet what it lists.
template <class General, unsigned Rays>
struct Active : Packets<General, Rays> {
  static constexpr RaysSent kRaysSent = RaysSent::kActive;
};

template <class General>
void expect_as_of_four(const char* configuration, const std::string& scene) {
  expect_as_general<Packets<General, 8>>(configuration, scene);
  expect_as_general<Packets<General, 16>>(configuration, scene);
}

TEST(PacketRays, PrimaryRaysHitWhatTheyHitAmongFour) {
  expect_as_of_four<config::thesis>("thesis", "blocks");
  expect_as_of_four<config::thesis>("thesis", "office");
}

TEST(PacketRays, LightAndReflectedRaysDoTooWhereTheyCross) {
  expect_as_of_four<config::whitted>("whitted", "lamps");
}

TEST(PacketRays, CornersAreMappedForEachRay) {
  expect_as_of_four<config::watertight>("watertight", "blocks");
}

TEST(PacketRays, RaysThatAreNotInALeafMissNothing) {
  expect_as_general<Active<config::thesis, 4>>("thesis", "blocks");
  expect_as_general<Active<config::thesis, 8>>("thesis", "office");
  expect_as_general<Active<config::whitted, 8>>("whitted", "lamps");
  expect_as_general<Active<config::whitted_split, 8>>("whitted_split", "lamps");
  expect_as_general<Active<config::watertight, 16>>("watertight", "blocks");
}

template <class General>
struct AtOnce : General {
  static constexpr Divider kDivider = Divider::kThreeReciprocals;
};

TEST(PacketRays, ReciprocalsAreTheSameOneByOneAndAtOnce) {
  expect_as_reciprocal<AtOnce<Reciprocal>>("blocks");
  expect_as_reciprocal<AtOnce<Active<Reciprocal, 8>>>("office");
}

template <class General>
struct PointsToLists : General {
  static constexpr Leaves kLeaves = Leaves::kPointers;
};

TEST(PacketRays, LeavesWithoutNodesAreMetAsThoseWithNodes) {
  expect_as_general<PointsToLists<config::thesis>>("thesis", "blocks");
  expect_as_general<PointsToLists<Active<config::thesis, 8>>>("thesis", "office");
  expect_as_general<PointsToLists<config::whitted>>("whitted", "lamps");
  expect_as_general<PointsToLists<config::whitted_split>>("whitted_split", "lamps");
  expect_as_general<PointsToLists<config::watertight>>("watertight", "blocks");
}

template <class General>
struct MainFirst : General {
  static constexpr bool kMainFirst = true;
};

TEST(PacketRays, WithTheMainObjectFirstTheSameIsHit) {
  const Frame tree = expect_as_general<config::thesis>("thesis", "conference");
  const Frame main = expect_as_general<MainFirst<PointsToLists<Active<config::thesis, 4>>>>(
      "thesis", "conference");
  EXPECT_LT(count_of(main, "list.transactions"), count_of(tree, "list.transactions"));
  expect_as_general<MainFirst<PointsToLists<Active<config::thesis, 8>>>>("thesis", "conference");
  expect_as_general<MainFirst<PointsToLists<Active<config::whitted, 4>>>>("whitted", "lamps");
  // Rays start in a list here too, but no tree over others follows.
  expect_as_general<MainFirst<PointsToLists<Active<config::thesis, 4>>>>("thesis", "blocks", merge);
}

TEST(PacketRays, EdgesOfTheImageCutPackets) {
  const auto four = board_of<config::thesis>();
  const auto sixteen = board_of<Packets<config::thesis, 16>>();
  const auto eight = board_of<Packets<config::thesis, 8>>();
  for (const auto [width, height] : {std::pair{1u, 1u}, {5u, 3u}, {37u, 26u}, {2u, 45u}}) {
    for (const RayOrder order : {RayOrder::kMorton, RayOrder::kScanline}) {
      FrameOptions options;
      options.width = width;
      options.height = height;
      options.order = order;
      const auto frame_of = [&](Board& board) {
        return render(board, options, host::laid_out("blocks", width, height, board.core()));
      };
      const Frame expected = frame_of(*four);
      for (Board* board : {eight.get(), sixteen.get()}) {
        const Comparison comparison = compare(frame_of(*board), expected);
        EXPECT_EQ(comparison.pixels, width * height);
        EXPECT_EQ(comparison.different_hits + comparison.different_pixels, 0u)
            << width << "x" << height << ": " << comparison.first->text("special", "thesis");
      }
    }
  }
}

TEST(PacketRays, APacketOfEightIsShadedForTwoOfFour) {
  const Frame four = expect_as_general<config::thesis>("thesis", "blocks");
  const Frame eight = expect_as_general<Packets<config::thesis, 8>>("thesis", "blocks");
  EXPECT_EQ(count_of(four, "shade_job.tokens"), kWidth * kHeight / 4);
  EXPECT_EQ(count_of(eight, "shade_job.tokens"), kWidth * kHeight / 8);
}

TEST(PacketRays, ALeafWithoutNodeCostsNoStep) {
  const Frame nodes = expect_as_general<config::thesis>("thesis", "office");
  const Frame pointers = expect_as_general<PointsToLists<config::thesis>>("thesis", "office");
  for (const char* counter : {"node_fetch.transactions", "slice_0.transactions"}) {
    EXPECT_LT(count_of(pointers, counter), count_of(nodes, counter)) << counter;
  }
}

TEST(PacketRays, RaysThatAreNotInALeafAreNotTransformed) {
  const Frame all = expect_as_general<Packets<config::thesis, 8>>("thesis", "office");
  const Frame active = expect_as_general<Active<config::thesis, 8>>("thesis", "office");
  const std::uint64_t vectors = count_of(all, "transformation.transactions");
  EXPECT_GT(vectors, kWidth * kHeight);
  EXPECT_LT(count_of(active, "transformation.transactions"), vectors - vectors / 8);
}

}  // namespace
}  // namespace dynrt::host::specialised
