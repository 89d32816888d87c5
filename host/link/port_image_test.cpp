// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/port_image.h"

#include <gtest/gtest.h>

#include "units/memory_format.h"

namespace dynrt::host {
namespace {

TEST(PortImage, PutsConsecutiveBytesTogether) {
  const MemoryRun runs[] = {{1, 10, {0x44332211, 0x88776655}}, {0, 10, {1, 2}}, {2, 7, {5}}};
  const std::vector<MemoryBytes> expected = {
      {80, {1, 0, 0, 0, 0x11, 0x22, 0x33, 0x44, 2, 0, 0, 0, 0x55, 0x66, 0x77, 0x88}},
      {kEntriesAt + 28, {5, 0, 0, 0}}};
  EXPECT_EQ(port_image(runs), expected);
}

TEST(PortImage, HasAZeroForTheFourthWordOfAColumn) {
  const MemoryRun runs[] = {
      {0, kColumnBase, {1, 1}}, {1, kColumnBase, {2, 2}}, {2, kColumnBase, {3, 3}}};
  const auto image = port_image(runs);
  const std::vector<MemoryBytes> expected = {
      {kColumnsAt, {1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0,
                    1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0}}};
  EXPECT_EQ(image, expected);
}

}  // namespace
}  // namespace dynrt::host
