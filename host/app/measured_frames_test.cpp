// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core's native model beside the truth: were truth and core not about the same rays, hits and
// rules of shading, hardly a pixel would agree.
#include <gtest/gtest.h>

#include "host/analysis/truth/measures.h"
#include "host/app/board_frame.h"

namespace dynrt::host {
namespace {

constexpr unsigned kWidth = 128;
constexpr unsigned kHeight = 96;

struct Case {
  const char* scene;
  const char* configuration;
  unsigned reflections;
};

class MeasuredFrames : public testing::TestWithParam<Case> {};

TEST_P(MeasuredFrames, AreNearlyTrue) {
  const Case& c = GetParam();
  const bool built = std::ranges::any_of(
      configurations(), [&](const Configuration& known) { return known.name == c.configuration; });
  if (!built) GTEST_SKIP() << "configuration " << c.configuration << " is not built";
  const auto board = make_board(configurations(), {"model", c.configuration, ""});
  SceneArguments arguments;
  arguments.scene = c.scene;
  arguments.width = kWidth;
  arguments.height = kHeight;
  const Prepared prepared = prepare(arguments, &board->core());
  FrameOptions options = arguments.frame_options();
  if (c.reflections > 0) options.reflections = c.reflections;
  const Frame frame = render_on(*board, options, prepared);

  const Truth truth(prepared.scene);
  const FrameConfig config = frame_config(board->core(), options, prepared.frame);
  const TruthFrame expected =
      truth_of_frame(truth, prepared.view.camera, shading_of(board->core(), config));
  const MatrixOwners owners(prepared.scene, prepared.objects, prepared.frame);
  const auto found = measure(truth, expected, frame, owners, board->core().format->number);
  SCOPED_TRACE(found.dump(2));
  RecordProperty("measures", found.dump());

  const auto& primary = found["primary"];
  EXPECT_GT(primary["hits"], 3000);
  EXPECT_LT(primary["wrong_share"], 0.005);
  EXPECT_LT(primary["t_median"], 2e-5);
  EXPECT_LT(primary["cosine_p99"], 1e-3);
  EXPECT_LT(found["image"]["differ_share"], 0.1);
  if (c.reflections == 0) return;
  EXPECT_GT(found["light"]["judged"], 2000);
  EXPECT_LT(found["light"]["wrong_share"], 0.01);
  EXPECT_LT(found["light"]["unexplained"], 20);
  EXPECT_GT(found["reflection"]["judged"], 300);
  EXPECT_LT(found["reflection"]["wrong_share"], 0.05);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeasuredFrames,
                         testing::Values(Case{"blocks", "thesis", 0}, Case{"office", "thesis", 0},
                                         Case{"lamps", "whitted", 2}),
                         [](const auto& info) { return std::string(info.param.scene); });

}  // namespace
}  // namespace dynrt::host
