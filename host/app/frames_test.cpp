// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Frame after frame on one board: nothing of a frame may be left in the next one's caches, counters
// or registers.
#include <gtest/gtest.h>

#include "host/app/board_frame.h"
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
    arguments.field_of_view = step.field_of_view;
    const Prepared prepared = prepare(arguments, kWidth, kHeight);
    FrameOptions options;
    options.width = kWidth;
    options.height = kHeight;
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

}  // namespace
}  // namespace dynrt::host
