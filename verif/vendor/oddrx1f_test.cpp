// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The model of the output cell: the order of its bits, and its reset.
#include <gtest/gtest.h>
#include <verilated.h>

#include <random>

#include "Voddrx1f.h"

namespace dynrt::verif {
namespace {

TEST(Oddrx1f, SendsTheFirstBitWhileTheClockIsHigh) {
  VerilatedContext context;
  Voddrx1f cell(&context);
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const bool first = random() % 2 != 0;
    const bool second = random() % 2 != 0;
    cell.D0 = first;
    cell.D1 = second;
    cell.eval();
    cell.SCLK = 1;
    cell.eval();
    EXPECT_EQ(cell.Q != 0, first);
    cell.D0 = !first;
    cell.D1 = !second;
    cell.eval();
    EXPECT_EQ(cell.Q != 0, first);
    cell.SCLK = 0;
    cell.eval();
    EXPECT_EQ(cell.Q != 0, second);
  }
}

TEST(Oddrx1f, IsResetAtAnyTime) {
  VerilatedContext context;
  Voddrx1f cell(&context);
  cell.D0 = 1;
  cell.D1 = 1;
  cell.eval();
  cell.SCLK = 1;
  cell.eval();
  EXPECT_EQ(cell.Q, 1);
  cell.RST = 1;
  cell.eval();
  EXPECT_EQ(cell.Q, 0);
  cell.SCLK = 0;
  cell.eval();
  EXPECT_EQ(cell.Q, 0);
}

}  // namespace
}  // namespace dynrt::verif
