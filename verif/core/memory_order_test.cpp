// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Every ray has the hit and the pixel that it has when the memory is in the order of the trees, and
// the core does the same work, whatever the lines that the host lays the trees out for. Hits name
// the same matrices.
#include <gtest/gtest.h>

#include "core/specialised.h"

namespace dynrt::host::specialised {
namespace {

MemoryImage in_lines_of(unsigned line_nodes, const std::string& scene, const Board& board) {
  CoreInfo core = board.core();
  core.line_nodes = line_nodes;
  return laid_out(scene, core);
}

class MemoryOrder : public testing::TestWithParam<const char*> {};

TEST_P(MemoryOrder, EveryRayHitsWhatItHits) {
  const auto board = make_board(configurations(), {"model", GetParam(), ""});
  for (const char* scene : {"blocks", "office", "trees4000"}) {
    const Frame plain = render(*board, small_frame(), in_lines_of(1, scene, *board));
    for (const unsigned line_nodes : {2, 4}) {
      const MemoryImage image = in_lines_of(line_nodes, scene, *board);
      const Frame frame = render(*board, small_frame(), image);
      expect_same_picture(frame, plain, scene, "in lines", "as before");
      for (const char* count : {"node_request.tokens", "list_request.tokens"}) {
        EXPECT_EQ(count_of(frame, count), count_of(plain, count));
      }
    }
  }
}

TEST_P(MemoryOrder, AlsoWhenInstancesHaveMoved) {
  const auto board = make_board(configurations(), {"model", GetParam(), ""});
  const auto moved = [&](unsigned line_nodes) {
    MemoryImage image = in_lines_of(line_nodes, "blocks", *board);
    for (Instance& instance : image.scene.instances) {
      instance.transform[3] += 0.01 * instance.transform[0];
    }
    image.frame = frame_of(image, instances_of(image), image.view.camera);
    return render(*board, small_frame(), image);
  };
  const Frame plain = moved(1);
  for (const unsigned line_nodes : {2, 4}) {
    expect_same_picture(moved(line_nodes), plain, "blocks", "in lines", "as before");
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, MemoryOrder, testing::Values("thesis", "fast"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace dynrt::host::specialised
