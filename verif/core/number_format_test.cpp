// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The configuration thesis with other floats, through the program's own path: memory, trees and hit
// records follow the float. The hits are compared with a tracer in doubles over the same trees;
// their allowed distance is stated in steps of the mantissa.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "configs/thesis.h"
#include "core/scenes.h"
#include "host/analysis/counts/counts.h"
#include "host/board/native_core.h"
#include "host/error.h"
#include "host/render/render.h"

namespace dynrt::host {
namespace {

constexpr unsigned kWidth = 64, kHeight = 48;

template <unsigned E, unsigned M, hls::Rounding R = hls::Rounding::kNearestEven>
struct ThesisIn : config::thesis {
  using Real = hls::Float<E, M, R>;
};

template <class C>
std::unique_ptr<Board> make() {
  CoreInfo info = core_info_of<C>();
  info.name = "thesis in another float";
  return std::make_unique<ModelBoard>(std::move(info), std::make_unique<NativeCoreOf<C>>());
}

struct Allowed {
  const char* name;
  std::unique_ptr<Board> (*board)();
  double other_hits;     ///< share of rays that hit something else, or nothing where there is
  double median_steps;   ///< error of t, in steps of the mantissa relative to t
  double largest_steps;  ///< the same, of the worst hit
};
std::ostream& operator<<(std::ostream& out, const Allowed& allowed) { return out << allowed.name; }

class InFormat : public testing::TestWithParam<Allowed> {};

std::vector<HitRecord> hits(Board& board, const MemoryImage& p) {
  FrameOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return render(board, options, p).hits;
}

TEST_P(InFormat, TheHitsAreThoseOfDoublesButForTheRounding) {
  const Allowed& allowed = GetParam();
  const auto board = allowed.board();
  const MemoryFormat& format = *board->core().format;
  const MemoryImage p = laid_out("blocks", kWidth, kHeight, board->core());
  const std::vector<HitRecord> records = hits(*board, p);
  const std::vector<TracedHit> truth =
      trace_frame(p.scene, p.trees, p.view.camera, kWidth, kHeight).hits;
  ASSERT_EQ(records.size(), truth.size());
  std::size_t others = 0;
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const HitRecord& got = records[i];
    const TracedHit& expected = truth[i];
    const auto& object = p.objects.objects[p.scene.instances[expected.instance].object];
    const bool same = got.hit == expected.hit &&
                      (!got.hit || (got.object == p.frame.first_instance + expected.instance &&
                                    got.triangle == object.first_matrix + expected.triangle));
    others += !same;
    if (same && got.hit) {
      errors.push_back(std::abs(format.number(got.t) / expected.t - 1) *
                       std::exp2(format.mantissa_bits));
    }
  }
  ASSERT_GT(errors.size(), truth.size() / 3);
  std::ranges::sort(errors);
  EXPECT_LE(static_cast<double>(others) / static_cast<double>(truth.size()), allowed.other_hits);
  EXPECT_LE(errors[errors.size() / 2], allowed.median_steps);
  EXPECT_LE(errors.back(), allowed.largest_steps);
}

INSTANTIATE_TEST_SUITE_P(Formats, InFormat,
                         testing::Values(Allowed{"E5M8", make<ThesisIn<5, 8>>, 0.12, 2, 64},
                                         Allowed{"E7M16", make<config::thesis>, 0.005, 2, 64},
                                         Allowed{"E8M23", make<ThesisIn<8, 23>>, 0.001, 2, 64}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace dynrt::host
