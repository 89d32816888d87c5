// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Frame after frame on one board: nothing of a frame may be left in the next one's caches, counters
// or registers.
#include <gtest/gtest.h>

#include "host/app/board_frame.h"
#include "host/app/walk.h"
#include "host/render/compare.h"

namespace dynrt::host {
namespace {

constexpr unsigned kWidth = 24;
constexpr unsigned kHeight = 16;

struct Step {
  const char* scene;
  double field_of_view;
  unsigned packets, lines;
};

TEST(Frames, EveryFrameOnOneBoardIsTheModels) {
  const auto rtl = make_board(configurations(), {"rtl", "thesis", ""});
  const auto model = make_board(configurations(), {"model", "thesis", ""});
  // Other cameras, scenes and sizes of everything that stays on the chip between frames; the
  // camera's matrix is at the same place with the same scene.
  constexpr Step kSteps[] = {{"blocks", 40, 32, 512}, {"blocks", 60, 32, 512},
                             {"blocks", 30, 1, 512},  {"office", 50, 32, 512},
                             {"blocks", 40, 7, 16},   {"blocks", 41, 32, 512},
                             {"blocks", 42, 32, 1}};
  for (const Step& step : kSteps) {
    SceneArguments arguments;
    arguments.scene = step.scene;
    arguments.width = kWidth;
    arguments.height = kHeight;
    arguments.camera.field_of_view = step.field_of_view;
    const Prepared prepared = prepare(arguments, &model->core());
    FrameOptions options = arguments.frame_options();
    options.packets = step.packets;
    options.lines = step.lines;
    options.timeout = 1'000'000;
    const Frame left = render_on(*rtl, options, prepared);
    const Frame right = render_on(*model, options, prepared);
    const Comparison comparison = compare(left, right);
    EXPECT_EQ(comparison.pixels, kWidth * kHeight);
    EXPECT_GT(comparison.hits, 0u);
    EXPECT_GT(comparison.counters, 30u);
    EXPECT_TRUE(comparison.identical())
        << step.scene << " at " << step.field_of_view << " degrees with " << step.packets
        << " packets, " << step.lines << " lines: " << comparison.first->text("rtl", "model");
  }
}

TEST(Frames, AWalkOnTheVerilogIsTheModels) {
  SceneArguments arguments;
  arguments.scene = "blocks";
  arguments.width = kWidth;
  arguments.height = kHeight;
  FrameOptions options = arguments.frame_options();
  options.timeout = 1'000'000;
  const auto rtl_board = make_board(configurations(), {"rtl", "thesis", ""});
  const auto model_board = make_board(configurations(), {"model", "thesis", ""});
  Prepared for_rtl = prepare(arguments, &rtl_board->core());
  Prepared for_model = for_rtl;
  const WalkPlan plan(for_rtl.scene, 3, {}, {});
  Walker rtl(*rtl_board, options, for_rtl, {}, plan);
  Walker model(*model_board, options, for_model, {}, plan);
  std::vector<std::uint32_t> before;
  for (unsigned i = 0; i < 3; ++i) {
    const Walker::Result left = rtl.render_frame(i, {});
    const Walker::Result right = model.render_frame(i, {});
    EXPECT_EQ(left.frame.pixels, right.frame.pixels) << "frame " << i;
    EXPECT_NE(left.frame.pixels, before) << "frame " << i << " is the one before";
    EXPECT_EQ(left.record.upload, right.record.upload);
    EXPECT_GT(left.record.cycles.value_or(0), 0u);
    before = left.frame.pixels;
  }
}

}  // namespace
}  // namespace dynrt::host
