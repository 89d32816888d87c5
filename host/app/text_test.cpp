// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/text.h"

#include <gtest/gtest.h>

namespace dynrt::host {
namespace {

TEST(Text, Sizes) {
  EXPECT_EQ(parse_size("512x384"), std::pair(512u, 384u));
  EXPECT_EQ(parse_size("0x1"), std::pair(0u, 1u));
}

TEST(Text, Vectors) { EXPECT_EQ(parse_vector("--up", "1,-2.5,3e2"), glm::dvec3(1, -2.5, 300)); }

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
