// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Settings that must not change a bit: caches, packets in flight, order, compression.
#include "host/analysis/stress/case.h"
#include "host/analysis/stress/chains.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

constexpr unsigned kMostLines = 512;

Trial spheres_in_a_room(const MemoryFormat& numbers) {
  Trial trial{.scene = scene_of(cube(4)), .shots = {}};
  for (int i = 0; i < 5; ++i) {
    add(trial.scene, sphere(numbers, 2), translation({i - 2.0, 0.5 * (i % 2), -0.5 * i}));
  }
  trial.shots = {picture({1, 0.75, 3.5}, {0, 0, 0}, 70, 21, 21)};
  return trial;
}

Case same_bits(const std::string& name, const std::string& about,
               const std::function<void(FrameOptions&, unsigned fewest_lines)>& change) {
  return Case(name, about, [change](Examiner& b) {
    Trial trial = spheres_in_a_room(b.numbers());
    const Rendered plain = b.check(trial);
    change(trial.shots[0].options, b.fewest_lines());
    b.expect_same(b.render(trial), plain);
  });
}

}  // namespace

std::vector<Case> frame_cases() {
  return {
      same_bits("one_line", "all caches of one line: the same bits",
                [](FrameOptions& o, unsigned fewest) { o.lines = fewest; }),
      same_bits("one_packet", "one packet in flight: the same bits",
                [](FrameOptions& o, unsigned) { o.packets = 1; }),
      same_bits("one_of_each", "one packet and caches of one line: the same bits",
                [](FrameOptions& o, unsigned fewest) { o.packets = 1, o.lines = fewest; }),
      same_bits("scanline", "packets line by line: the same bits",
                [](FrameOptions& o, unsigned) { o.order = RayOrder::kScanline; }),
      same_bits("uncompressed", "every ray with its own origin: the same bits",
                [](FrameOptions& o, unsigned) { o.uncompressed = true; }),
      Case("one_slot", "63 nodes of a tree in one cache line of 512: the same bits",
           [](Examiner& b) {
             const Rendered plain = b.check(lower_chain(b.numbers(), 31));
             b.expect_same(b.check(lower_chain(b.numbers(), 31, kMostLines - 1)), plain);
           }),
  };
}

}  // namespace dynrt::host::stress
