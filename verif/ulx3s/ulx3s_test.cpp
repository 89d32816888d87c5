// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Frames of the ULX3S, simulated down to its pins, against those of the model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "configs/fast_port.h"
#include "core/specialised.h"
#include "host/board/rtl_board.h"
#include "host/ulx3s/linked_board.h"
#include "host/ulx3s/simulated_ulx3s.h"

namespace dynrt::host {
namespace {

using config::fast_port;

constexpr std::chrono::microseconds kPause{100};

/// A simulated board that a link reaches.
struct Simulated {
  SimulatedUlx3s* ulx3s;
  std::unique_ptr<RtlBoard> board;

  explicit Simulated(bool by_back_door) {
    auto simulated = make_simulated_ulx3s();
    ulx3s = simulated.get();
    auto linked = std::make_unique<LinkedBoard>(std::make_unique<BoardLink>(std::move(simulated)),
                                                by_back_door ? ulx3s : nullptr,
                                                [this] { ulx3s->run(kPause); });
    board = std::make_unique<RtlBoard>(core_info_of_listed<fast_port>("fast_port"),
                                       std::move(linked), std::vector<Counter>{});
  }
};

TEST(Ulx3s, RendersAsTheModelDoes) {
  FrameOptions options;
  options.width = 64;
  options.height = 48;
  options.hits = true;
  options.timeout = 10'000'000;
  Simulated simulated(true);
  const MemoryImage image =
      laid_out("office", options.width, options.height, simulated.board->core());
  const Frame there = render(*simulated.board, options, image);
  const auto model = specialised::board_of<fast_port>();
  const Frame here = render(*model, options, image);
  EXPECT_EQ(there.pixels, here.pixels);
  EXPECT_EQ(there.hits, here.hits);
  std::printf("%llu clocks\n", static_cast<unsigned long long>(*there.run.cycles));
}

}  // namespace
}  // namespace dynrt::host
