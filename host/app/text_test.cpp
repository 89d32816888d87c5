// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/text.h"

#include <gtest/gtest.h>

namespace dynrt::host {
namespace {

TEST(Text, ListsOfNumbers) {
  std::array<unsigned, 2> size{};
  EXPECT_TRUE(parse_list("512x384", 'x', size));
  EXPECT_EQ(size, (std::array{512u, 384u}));
  for (const char* other : {"", "512", "512x", "512x384x", "512x384x3", "x384", "512,384"}) {
    EXPECT_FALSE(parse_list(other, 'x', size)) << other;
  }
  std::array<double, 3> vector{};
  EXPECT_TRUE(parse_list("1,-2.5,3e2", ',', vector));
  EXPECT_EQ(vector, (std::array{1.0, -2.5, 300.0}));
}

TEST(Text, GroupsOfThreeDigits) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(1234567), "1,234,567");
  EXPECT_EQ(counted(1, "object"), "1 object");
  EXPECT_EQ(counted(1200, "object"), "1,200 objects");
}

}  // namespace
}  // namespace dynrt::host
