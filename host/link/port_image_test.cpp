// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/port_image.h"

#include <gtest/gtest.h>

#include "units/memory_format.h"

namespace dynrt::host {
namespace {

TEST(PortImage, HasEachWordWhereTheCoreReadsIt) {
  std::size_t words = 0;
  for (std::uint32_t port_word = 0; port_word < 1u << (kPortAddressBits - 2); port_word += 3) {
    const BankWord at = bank_word(port_word);
    if (at.bank == kSceneBanks) continue;
    // Between the entries and the columns are no items.
    if (at.bank == 2 && at.word >= kColumnBase && 4 * port_word < kColumnsAt) continue;
    ASSERT_EQ(port_address(at.bank, at.word), 4 * port_word);
    ++words;
  }
  EXPECT_GT(words, 500'000u);
}

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
