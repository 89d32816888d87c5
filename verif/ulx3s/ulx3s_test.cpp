// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Frames of the ULX3S, simulated down to its pins, against those of the model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "configs/fast_ulx3s.h"
#include "core/specialised.h"
#include "host/board/registers.h"
#include "host/render/compare.h"
#include "host/ulx3s/board_at_link.h"
#include "host/ulx3s/linked_board.h"
#include "host/ulx3s/simulated_ulx3s.h"

namespace dynrt::host {
namespace {

namespace reg = registers;
using config::fast_ulx3s;

FrameOptions options(unsigned width, unsigned height) {
  FrameOptions options;
  options.width = width;
  options.height = height;
  options.hits = true;
  options.timeout = 10'000'000;
  return options;
}

void expect_as_the_model(Board& board, const std::string& scene, const FrameOptions& options,
                         const ChangeScene& change = {}) {
  const MemoryImage image = laid_out(scene, options.width, options.height, board.core(), change);
  const Frame there = render(board, options, image);
  EXPECT_EQ(there.clock_hz, 62.5e6);
  EXPECT_FALSE(there.timing);
  EXPECT_FALSE(there.run.missed_pixels);
  // Each word of the scene took its place on the line, or would have.
  EXPECT_GT(there.upload.bytes_written, 1000u);
  EXPECT_GT(there.upload.seconds(), static_cast<double>(there.upload.bytes_written) * 10 / 3e6);
  // Hit records of 24 bytes and pixels of two or four come once.
  const std::uint64_t rays = std::uint64_t{options.width} * options.height;
  EXPECT_GT(there.traffic.bytes_read, rays * 24);
  EXPECT_LT(there.traffic.bytes_read, rays * 36);
  Frame here = render(*specialised::board_of<fast_ulx3s>(), options, image);
  here.core.name = there.core.name;  // so that counters are compared
  EXPECT_GT(there.hit_count(), 0u);
  const Comparison comparison = compare(there, here);
  EXPECT_TRUE(comparison.identical()) << comparison.first->text("ulx3s", "model");
  EXPECT_GT(comparison.counters, 20u);
}

/// The pixels are those that a monitor sees at the DVI pins; the counters come over the line. The
/// second frame lies in the other buffer, and is shown from there.
TEST(Ulx3s, SlowShowsThePictureOfTheModel) {
  const auto board = make_board_at_link("ulx3s");
  FrameOptions of_frame = options(64, 48);
  expect_as_the_model(*board, "office", of_frame);
  of_frame.buffer = 1;
  expect_as_the_model(*board, "cistern", of_frame);
}

/// A few triangles of each object, which a line carries in no time.
void make_small(Scene& scene) {
  constexpr std::size_t kTriangles = 6;
  for (Mesh& mesh : scene.objects) {
    if (mesh.triangles.size() <= kTriangles) continue;
    mesh.triangles.resize(kTriangles);
    mesh.material.resize(kTriangles);
  }
}

/// Scene, registers and hit records, at 3 Mbaud; the pixels too, which are read back as well.
TEST(Ulx3s, TakesASceneOverTheLine) {
  auto simulated = make_simulated_ulx3s();
  SimulatedUlx3s* const ulx3s = simulated.get();
  auto link = std::make_unique<BoardLink>(std::move(simulated));
  const LinkedCore& core = linked_core(*link, "ulx3s");
  auto linked = std::make_unique<LinkedBoard>(
      std::move(link), nullptr, [ulx3s] { ulx3s->run(std::chrono::microseconds(100)); });
  const LinkedBoard& line = *linked;
  BoardAtLink board("ulx3s", core, std::move(linked), nullptr);
  expect_as_the_model(board, "blocks", options(16, 12), make_small);
  EXPECT_GT(line.uploaded(), 1000u);
  EXPECT_GT(line.counts().carried, line.uploaded() + 16 * 12 * (2 + 24));
  EXPECT_EQ(line.counts().repeats, 0u);
  EXPECT_GT(ulx3s->memory_use().words_written, line.uploaded() / 2);
  EXPECT_EQ(board.read_register(reg::kRegFrameWords), core.info().frame_words({}).size());
  EXPECT_EQ(board.read_register(reg::kRegFrame), 0u) << "the board is built without READ_BACK";
}

}  // namespace
}  // namespace dynrt::host
