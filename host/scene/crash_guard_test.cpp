// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/crash_guard.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace dynrt::host {
namespace {

using testing::ExitedWithCode;

/// Fills the stack, unless the depth is negative.
int without_end(int depth) {  // NOLINT(misc-no-recursion)
  if (depth < 0) return 0;
  volatile char room[4096];
  room[depth % 4096] = static_cast<char>(depth);
  return without_end(depth + 1) + room[(depth + 1) % 4096];
}

class CrashGuardDeathTest : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(CrashGuardDeathTest, NamesTheFileOfACrash) {
  for (const int crash : {SIGSEGV, SIGABRT, SIGFPE}) {
    EXPECT_EXIT(
        {
          const CrashGuard guard("damaged.blend: is damaged");
          std::raise(crash);
        },
        ExitedWithCode(2), "^dynrt: damaged.blend: is damaged\n$");
  }
}

TEST_F(CrashGuardDeathTest, DoesSoWhenTheStackIsFull) {
  EXPECT_EXIT(
      {
        const CrashGuard guard("deep.x: is damaged");
        std::exit(without_end(0));
      },
      ExitedWithCode(2), "deep.x: is damaged");
}

TEST_F(CrashGuardDeathTest, GivesWayToTheGuardAroundIt) {
  EXPECT_EXIT(
      {
        const CrashGuard outer("outer");
        {
          const CrashGuard inner("inner");
        }
        std::raise(SIGSEGV);
      },
      ExitedWithCode(2), "^dynrt: outer\n$");
}

TEST_F(CrashGuardDeathTest, LeavesCrashesAloneAtItsEnd) {
  EXPECT_EXIT(
      {
        {
          const CrashGuard guard("no more");
        }
        std::raise(SIGSEGV);
      },
      [](int status) { return !ExitedWithCode(2)(status); }, "");
}

}  // namespace
}  // namespace dynrt::host
