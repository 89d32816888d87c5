// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The parts that a core of two levels can do without: each is gone when a configuration says so and
// there when it does not, a scene that asks for it is refused, and one that does not has the same
// hit records and pixels.
#include "core/specialised.h"

#include <gmock/gmock.h>

#include "configs/thesis.h"
#include "configs/whitted.h"
#include "host/render/figures.h"
#include "host/specialise/decide.h"

namespace dynrt::host::specialised {
namespace {

using testing::MatchesRegex;
using Thesis = config::thesis;

/// Enough for `blocks` and `lamps`, which take fewer than 2^13 nodes and list entries and than 2^11
/// matrices, and whose trees are not deep.
template <class General>
struct Lean : General {
  static constexpr unsigned kStackDepth = 20;
  static constexpr unsigned kAddressBits = 13;
  static constexpr unsigned kMatrixBits = 11;
  static constexpr unsigned kObjectSlots = 0;
  static constexpr unsigned kTriangleSlots = 0;
  static constexpr bool kUncompressed = false;
  static constexpr bool kCounters = false;
};
/// As deep as the trees of `blocks` ask for, and far less.
struct Tight : Thesis {
  static constexpr unsigned kStackDepth = 18;
};
struct Shallow : Thesis {
  static constexpr unsigned kStackDepth = 2;
};
struct OneColour : Thesis {
  static constexpr bool kOneColour = true;
};
struct LitInOneColour : Lean<config::whitted> {
  static constexpr bool kOneColour = true;
  static constexpr unsigned kTriangleSlots = 8;
};

TEST(Specialised, TheSameHitsAndPixels) {
  expect_as_general<Lean<Thesis>>("thesis", "blocks");
  expect_as_general<OneColour>("thesis", "blocks", paint);
}

TEST(Specialised, TheSameLightAndReflections) {
  expect_as_general<LitInOneColour>("whitted", "lamps", paint);
}

TEST(Specialised, ACoreWithoutCountersCountsNothing) {
  EXPECT_TRUE(expect_as_general<Lean<Thesis>>("thesis", "blocks").counters.empty());
  const auto general = make_board(configurations(), {"model", "thesis", ""});
  EXPECT_FALSE(rendered(*general, "blocks", {}).counters.empty());
}

TEST(Specialised, OnlyACoreOfUncompressedPacketsHasTheirRegister) {
  EXPECT_TRUE(is_there(MatrixStore<Thesis>().frame));
  EXPECT_FALSE(is_there(MatrixStore<Lean<Thesis>>().frame));
  EXPECT_EQ(frame_words_of<Lean<Thesis>>({}).size() + 1, frame_words_of<Thesis>({}).size());
  FrameOptions options = small_frame();
  options.uncompressed = true;
  CoreInfo board = core_info_of<Lean<Thesis>>();
  board.name = "special";
  EXPECT_EQ(refusal([&] { frame_config(board, options, {}); }),
            "configuration special transforms one origin for all rays of a packet and cannot "
            "transform one for each ray; take another configuration");
}

TEST(Specialised, RegistersGoToTheirPlaces) {
  FrameConfig frame;
  frame.write_hits = to_word(1);
  frame.uncompressed = to_word(2);
  frame.ambient = to_word(3);
  frame.reflections = to_word(4);
  frame.colour = to_word(5);
  frame.object = to_word(6);
  const auto words = frame_words_of<Thesis>(frame);
  ASSERT_EQ(words.size(), 16u);
  EXPECT_EQ(words[10], 1u);
  EXPECT_EQ(words[11], 2u);
  EXPECT_EQ(words[12], 3u);
  EXPECT_EQ(words[15], 4u);
  EXPECT_EQ(frame_words_of<Lean<Thesis>>(frame)[11], 3u);
  EXPECT_EQ(frame_words_of<OneColour>(frame)[16], 5u);
}

TEST(Specialised, StacksTakeTheRowsOfTheTreesDepths) {
  EXPECT_EQ(kStackRows<Thesis>, 32u * 64);
  EXPECT_EQ(kStackRows<Lean<Thesis>>, 32u * 64);
  EXPECT_EQ(core_info_of<Lean<Thesis>>().stack_depth, 20u);
}

TEST(Specialised, StacksOfTheDepthsThatAreDecidedDropNothing) {
  const MemoryImage blocks = laid_out("blocks", core_info_of<Thesis>());
  for (const Decision& one : decide(blocks.needs(), core_info_of<Thesis>(), {})) {
    if (one.key == "stack_depth") EXPECT_EQ(one.value, Tight::kStackDepth);
  }
  // Trees are not made shallower for the stacks: too short ones must drop pushes.
  const auto dropped = [](Board& board) {
    const MemoryImage deep =
        host::laid_out("blocks", kWidth, kHeight, board.core(), {}, {.spare_stacks = false});
    return figures_of(render(board, small_frame(), deep), 1e6).dropped_pushes.value();
  };
  EXPECT_EQ(dropped(*board_of<Tight>()), 0u);
  EXPECT_GT(dropped(*board_of<Shallow>()), 0u);
}

template <class C, template <class> class Kind>
using Row = typename CacheFill<C, Kind<C>>::Row;

TEST(Specialised, NumbersTakeTheBitsOfTheirScene) {
  using Special = Lean<Thesis>;
  EXPECT_EQ((kSaved<Row<Thesis, NodeCache>, Row<Special, NodeCache>>), 6u * 3)
      << "the tag and two children";
  EXPECT_EQ((kSaved<Row<Thesis, ListCache>, Row<Special, ListCache>>), 6u + 6u + 14u)
      << "the tag, the matrix and what is reserved";
  EXPECT_EQ((kSaved<Row<Thesis, MatrixCache>, Row<Special, MatrixCache>>), 6u) << "the tag";
  EXPECT_EQ((kSaved<dynrt::HitRecord<Thesis>, dynrt::HitRecord<Special>>), 6u * 2)
      << "object and triangle";
  EXPECT_EQ((kSaved<NodeFetch<Thesis>::Entry, NodeFetch<Special>::Entry>), 6u);
}

TEST(Specialised, AnImageBeyondTheCoresReachIsRefused) {
  CoreInfo board = core_info_of<Thesis>();
  board.address_bits = 4;
  EXPECT_THAT(refusal([&] { laid_out("blocks", board); }),
              MatchesRegex("scene 'blocks' needs [0-9]+ tree nodes, [0-9]+ more than the 15 that "
                           "the core reaches; take a configuration with more address_bits than 4"));
  board.address_bits = kAddressBits;
  board.matrix_bits = 3;
  EXPECT_THAT(refusal([&] { laid_out("blocks", board); }),
              MatchesRegex("scene 'blocks' needs [0-9]+ matrices .* more than the 8 that the core "
                           "reaches; take a configuration with more matrix_bits than 3"));
}

TEST(Specialised, OneColourIsNotStored) {
  EXPECT_EQ((kSaved<dynrt::HitRecord<Thesis>, dynrt::HitRecord<OneColour>>), 24u);
  EXPECT_EQ((kSaved<JobRecord<Thesis>, JobRecord<OneColour>>), 24u - kAddressBits);
  EXPECT_EQ((kSaved<Found<config::whitted>, Found<LitInOneColour>>), 24u + 6u * 2);
  const CoreInfo board = core_info_of<OneColour>();
  EXPECT_THAT(refusal([&] { laid_out("blocks", board); }),
              MatchesRegex("scene 'blocks' has surfaces of the colours 0x[0-9a-f]+ and 0x[0-9a-f]+ "
                           "[(]object '.*', 0xBBGGRR[)], but the core has one colour for all; take "
                           "a configuration without one_colour"));
}

}  // namespace
}  // namespace dynrt::host::specialised
