// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Packets of eight and of sixteen rays: every ray has the hit and the pixel that it has among four,
// whichever rays travel with it, and the image's edges may cut a packet anywhere.
#include <algorithm>

#include "configs/fast.h"
#include "configs/thesis.h"
#include "configs/watertight.h"
#include "configs/whitted.h"
#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

template <class General, unsigned Rays>
struct Packets : General {
  static constexpr unsigned kPacketRays = Rays;
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

TEST(PacketRays, RaysOfTheFastDatapathDoToo) {
  const Frame eight = rendered(*board_of<config::fast>(), "office", {});
  for (const auto& board :
       {board_of<Packets<config::fast, 4>>(), board_of<Packets<config::fast, 16>>()}) {
    expect_same_picture(rendered(*board, "office", {}), eight, "office", "special", "fast");
  }
}

struct TreeFirst : config::fast {
  static constexpr bool kMainFirst = false;
};

TEST(PacketRays, WithTheMainObjectFirstTheSameIsHit) {
  const auto main_first = board_of<config::fast>();
  const auto tree_first = board_of<TreeFirst>();
  const Frame main = rendered(*main_first, "conference", {});
  const Frame tree = rendered(*tree_first, "conference", {});
  expect_same_picture(main, tree, "conference", "main object first", "tree first");
  EXPECT_LT(count_of(main, "list.transactions"), count_of(tree, "list.transactions"));
  // Rays start in a list here too, but no tree over others follows.
  expect_same_picture(rendered(*main_first, "blocks", merge),
                      rendered(*tree_first, "blocks", merge), "blocks", "main object first",
                      "tree first");
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

}  // namespace
}  // namespace dynrt::host::specialised
