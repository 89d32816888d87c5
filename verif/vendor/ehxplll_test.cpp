// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The model of the PLL: frequencies and phases of its outputs, and each limit of the data sheet
// crossed once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "Vpll.h"
#include "Vpll_by_zero.h"
#include "Vpll_input_divided.h"
#include "Vpll_inside.h"
#include "Vpll_of_no_output.h"
#include "Vpll_of_no_path.h"
#include "Vpll_output.h"
#include "host/board/timed_top.h"

namespace dynrt::verif {
namespace {

using testing::HasSubstr;
using Edges = std::vector<std::uint64_t>;

/// Notes when a signal rises.
class Rises {
 public:
  void look(std::uint64_t now, bool level) {
    if (level && !level_) times.push_back(now);
    level_ = level;
  }
  Edges times;

 private:
  bool level_ = false;
};

constexpr std::uint64_t kMicrosecond = 1'000'000;

/// With CLKFB where CLKOP is, as a net of the top would have it.
template <class Pll>
void step(Pll& pll) {
  pll.CLKFB = pll.CLKOP;
  pll.eval();
}

TEST(Ehxplll, MultipliesDividesAndDelays) {
  VerilatedContext context;
  Vpll pll(&context);
  host::TimedTop<Vpll> run(pll);
  run.add_clock(pll.CLKI, 25'000);  // 40 MHz, so a VCO of 40 / 2 * 5 * 8 = 800 MHz
  Rises in, op, os, os2;
  run.run(4 * kMicrosecond, [&](std::uint64_t now) {
    step(pll);
    in.look(now, pll.CLKI);
    op.look(now, pll.CLKOP);
    os.look(now, pll.CLKOS);
    os2.look(now, pll.CLKOS2);
  });
  EXPECT_EQ(pll.LOCK, 1);
  ASSERT_GT(op.times.size(), 100u);
  for (std::size_t i = 1; i < op.times.size(); ++i) {
    EXPECT_EQ(op.times[i] - op.times[i - 1], 10'000u);
  }
  for (std::size_t i = 1; i < os.times.size(); ++i) {
    EXPECT_EQ(os.times[i] - os.times[i - 1], 40'000u);
  }
  for (std::size_t i = 1; i < os2.times.size(); ++i) {
    EXPECT_EQ(os2.times[i] - os2.times[i - 1], 6'250u);
  }
  // An edge of the output that is fed back is one of the input's; 2.5 periods of the VCO later
  // comes CLKOS, which has a phase of 9.5 against 7.
  EXPECT_TRUE(std::ranges::find(in.times, op.times[0]) != in.times.end());
  EXPECT_EQ(os.times[0], op.times[0] + 3'125);
  EXPECT_EQ(os2.times[0], op.times[0]);
}

TEST(Ehxplll, IsFedBackInsideAndKeepsItsRate) {
  VerilatedContext context;
  Vpll_inside pll(&context);
  host::TimedTop<Vpll_inside> run(pll);
  run.add_clock(pll.CLKI, 30'303);  // a VCO of 33 / 3 * 29 * 2 = 638 MHz
  Rises op;
  run.run(40 * kMicrosecond, [&](std::uint64_t now) { op.look(now, pll.CLKOP); });
  ASSERT_GT(op.times.size(), 1000u);
  const double period = 30'303.0 * 3 / 29 / 2 * 3;
  for (std::size_t i = 0; i < op.times.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(op.times[i] - op.times[0]), period * static_cast<double>(i),
                1.001);
  }
}

TEST(Ehxplll, StartsAnewAfterAReset) {
  VerilatedContext context;
  Vpll pll(&context);
  host::TimedTop<Vpll> run(pll);
  run.add_clock(pll.CLKI, 25'000);
  const auto look = [&](std::uint64_t) { step(pll); };
  run.run(4 * kMicrosecond, look);
  pll.RST = 1;
  run.run(100'000, look);
  EXPECT_EQ(pll.LOCK, 0);
  Rises op;
  run.run(kMicrosecond, [&](std::uint64_t now) {
    step(pll);
    op.look(now, pll.CLKOP);
  });
  EXPECT_TRUE(op.times.empty());
  pll.RST = 0;
  run.run(4 * kMicrosecond, look);
  EXPECT_EQ(pll.LOCK, 1);
}

/// What the model says of an input of such a period.
template <class Pll>
std::string refusal(std::uint64_t period, bool feed_back = true) {
  VerilatedContext context;
  context.fatalOnError(false);
  Pll pll(&context);
  host::TimedTop<Pll> run(pll);
  run.add_clock(pll.CLKI, period);
  testing::internal::CaptureStdout();
  run.run(200 * period, [&](std::uint64_t) {
    if (feed_back) step(pll);
  });
  EXPECT_TRUE(context.gotError());
  return testing::internal::GetCapturedStdout();
}

TEST(Ehxplll, RefusesClocksOutsideTheLimits) {
  EXPECT_THAT(refusal<Vpll>(125'001), HasSubstr("the clock at CLKI is 8.000 MHz and must be 8.000 "
                                                "to 400.000 MHz"));
  EXPECT_THAT(refusal<Vpll>(24'000),
              HasSubstr("the VCO's clock, CLKI / 2 * 5 * 8 (CLKI_DIV, CLKFB_DIV, divider fed "
                        "back), is 833.333 MHz and must be 400.000 to 800.000 MHz"));
  EXPECT_THAT(refusal<Vpll>(50'400), HasSubstr("is 396.825 MHz and must be 400.000 to 800.000"));
  EXPECT_THAT(
      refusal<Vpll_input_divided>(40'000),
      HasSubstr("the clock at CLKI divided by CLKI_DIV, 4, is 6.250 MHz and must be 10.000"));
  EXPECT_THAT(refusal<Vpll_output>(40'000),
              HasSubstr("the clock of output 1, the VCO's divided by 1, is 600.000 MHz and must be "
                        "3.125 to 400.000 MHz"));
}

TEST(Ehxplll, RefusesParametersThatDoNotFit) {
  EXPECT_THAT(refusal<Vpll_of_no_output>(40'000),
              HasSubstr("FEEDBK_PATH names output 1, which is not ENABLED"));
  EXPECT_THAT(refusal<Vpll_of_no_path>(40'000), HasSubstr("FEEDBK_PATH must be CLKOP, CLKOS,"));
  EXPECT_THAT(refusal<Vpll_by_zero>(40'000), HasSubstr("a divider is 0 and must be 1 to 128"));
}

TEST(Ehxplll, RefusesAFeedbackFromElsewhere) {
  EXPECT_THAT(refusal<Vpll>(25'000, false),
              HasSubstr("CLKFB is not joined to output 0, which FEEDBK_PATH names"));
}

}  // namespace
}  // namespace dynrt::verif
