// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Scenes over the line: how long they take at its speed, at first and when they move, and one
// whole.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "configs/fast_ulx3s.h"
#include "core/scenes.h"
#include "host/link/port_image.h"
#include "host/link/upload_plan.h"
#include "host/scene/animation.h"
#include "link/simulated_line.h"
#include "link/test_board.h"

namespace dynrt::host {
namespace {

constexpr unsigned kWidth = 512, kHeight = 384;

/// For the core of the ULX3S.
MemoryImage image_of(const std::string& scene) {
  return laid_out(scene, kWidth, kHeight, core_info_of_listed<config::fast_ulx3s>("fast_ulx3s"));
}

void print(const std::string& what, const LineCost& cost) {
  fmt::print("{}: {:.2f} MB in {} frames, {:.1f} % of the line's bytes, {:.3f} s\n", what,
             static_cast<double>(cost.carried) / 1e6, cost.frames,
             100.0 * static_cast<double>(cost.carried) / static_cast<double>(cost.sent),
             cost.seconds);
}

/// Prints the time of the whole scene, and of the changes in ten frames of a 30th of a second, in
/// which objects and camera move.
class SceneUpload : public testing::TestWithParam<const char*> {};
TEST_P(SceneUpload, SendsLessWhenItMoves) {
  const std::string name = GetParam();
  MemoryImage image = image_of(name);
  UploadPlan plan;
  const auto first = plan.changes(port_image(image.runs()));
  const LineCost whole = upload_cost(first);
  print(name, whole);
  EXPECT_GT(static_cast<double>(whole.carried) / static_cast<double>(whole.sent), 0.9);
  EXPECT_EQ(upload_cost(plan.changes(port_image(image.runs()))).sent, 0u);
  if (!(duration(image.scene) > 0)) return;
  LineCost moved;
  constexpr unsigned kFrames = 10;
  for (unsigned i = 1; i <= kFrames; ++i) {
    move_to(image.scene, i / 30.0);
    const Camera camera = choose_camera(image.scene, {}, kWidth, kHeight);
    const FrameImage frame = frame_of(image, instances_of(image), camera);
    const LineCost cost = upload_cost(plan.changes(port_image(frame.memory.runs())));
    moved.frames += cost.frames;
    moved.carried += cost.carried;
    moved.sent += cost.sent;
    moved.seconds += cost.seconds;
  }
  if (moved.sent > 0) print(fmt::format("{}, {} frames of it", name, kFrames), moved);
  EXPECT_LT(moved.sent, kFrames * whole.sent / 10);
  EXPECT_GT(moved.sent, 0u);
}
INSTANTIATE_TEST_SUITE_P(Of, SceneUpload,
                         testing::Values("office", "cistern", "conference", "trees4000", "blocks"),
                         [](const auto& info) { return std::string(info.param); });

/// A small scene over a line that makes mistakes, at its speed.
TEST(SceneUploadOverTheLine, MakesTheMemoryTheScene) {
  const auto image = port_image(image_of("blocks").runs());
  std::size_t end = 0;
  for (const MemoryBytes& part : image) end = std::max(end, part.address + part.bytes.size());
  TestBoard board(1 << 24);
  ASSERT_LE(end, board.model.memory().size());
  auto owned = std::make_unique<SimulatedLine>(
      [&board](std::span<const std::uint8_t> bytes) { return board.model.answer(bytes); },
      SimulatedLine::Settings{.mistakes = {1e-5, 1e-5, 1e-5, 1e-5, 1e-5},
                              .latency = std::chrono::milliseconds(1)});
  const SimulatedLine& line = *owned;
  BoardLink link(std::move(owned));
  UploadPlan plan;
  const auto parts = plan.changes(image);
  const auto begin = line.now();
  link.write_memory(parts);
  const std::chrono::duration<double> time = line.now() - begin;
  for (const MemoryBytes& part : image) {
    ASSERT_TRUE(std::ranges::equal(
        part.bytes, std::span(board.model.memory()).subspan(part.address, part.bytes.size())));
  }
  fmt::print("blocks over a line with {} mistakes: {:.3f} s, {} repeats; {:.3f} s without\n",
             line.mistakes(), time.count(), link.counts().repeats, upload_cost(parts).seconds);
}

}  // namespace
}  // namespace dynrt::host
