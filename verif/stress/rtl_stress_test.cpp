// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Every stress case, RTL against model, to the last bit: hits, pixels, counters that do not depend
// on the order of packets. Once on the board that the program uses, once on the one that checks the
// Verilog's assertions and starts with random values, other ones in every case.
#include <algorithm>

#include "host/board/rtl_board.h"
#include "host/error.h"
#include "host/render/compare.h"
#include "verif/stress/stress_boards.h"

namespace dynrt::host::stress {
namespace {

/// Whether the table says that this build makes Verilog of a configuration.
bool has_rtl(const std::string& configuration) {
  const Configuration* row = row_of(configuration);
  return row != nullptr && row->lowered;
}

std::unique_ptr<Board> open_rtl(const std::string& configuration) {
  if (!has_rtl(configuration)) return nullptr;
  return make_board(configurations(), {"rtl", configuration, ""});
}

OpenBoard open_checked(int seed) {
  return [seed](const std::string& configuration) -> std::unique_ptr<Board> {
    if (!has_rtl(configuration)) return nullptr;
    const Configuration& c = find_configuration(configurations(), configuration, true);
    if (c.traced == nullptr) throw UserError(configuration + " has no Verilog in this build");
    CoreInfo info = c.core();
    info.name = configuration;
    return std::make_unique<RtlBoard>(std::move(info), c.traced("", seed),
                                      counters_of(c.core_json()));
  };
}

std::vector<Frame> frames_of(const Case& c, const OpenBoard& open,
                             const std::string& configuration) {
  std::vector<Frame> frames;
  Boards boards(open, configuration);
  run_case(c, boards, &frames);
  return frames;
}

void expect_identical(const std::vector<Frame>& rtl, const std::vector<Frame>& model) {
  ASSERT_EQ(rtl.size(), model.size());
  for (std::size_t i = 0; i < rtl.size(); ++i) {
    const Comparison comparison = compare(rtl[i], model[i]);
    EXPECT_EQ(comparison.pixels, std::uint64_t{rtl[i].width} * rtl[i].height);
    EXPECT_GT(comparison.counters, 30u);
    ASSERT_TRUE(comparison.identical())
        << "frame " << i << ": " << comparison.first->text("rtl", "model");
  }
}

class RtlStress : public ::testing::TestWithParam<Parameter> {};

TEST_P(RtlStress, IsTheModel) {
  const auto& [configuration, number] = GetParam();
  const Case& c = cases()[number];
  try {
    const std::vector<Frame> model = frames_of(c, open_model, configuration);
    expect_identical(frames_of(c, open_rtl, configuration), model);
    expect_identical(frames_of(c, open_checked(static_cast<int>(number) + 1), configuration),
                     model);
  } catch (const NoBoard& lacking) {
    GTEST_SKIP() << lacking.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Every, RtlStress, every_case(), name_of);

}  // namespace
}  // namespace dynrt::host::stress
