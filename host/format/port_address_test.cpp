// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/format/port_address.h"

#include <gtest/gtest.h>

namespace dynrt::host {
namespace {

TEST(PortAddress, EveryWordOfABankHasAPlaceOfItsOwn) {
  for (unsigned bank = 0; bank < kBanks; ++bank) {
    for (const std::uint32_t word :
         {0u, 1u, 2u, 777u, kColumnBase - 1, kColumnBase, kColumnBase + 5, kBankWords - 1}) {
      const BankWord at = bank_word(port_place(bank, word).byte);
      EXPECT_EQ(at.bank, bank) << word;
      EXPECT_EQ(at.word, word) << bank;
    }
  }
}

TEST(PortAddress, EveryWordOfTheMemoryThatABankHoldsIsFound) {
  std::size_t words = 0;
  for (unsigned byte = 0; byte < 1u << kMemoryAddressBits; byte += 12) {
    const BankWord at = bank_word(byte);
    if (at.bank == kBanks) continue;
    // Between the entries and the columns are no items, nor behind the pixels.
    if (at.bank == 2 && at.word >= kColumnBase && byte < kColumnsAt) continue;
    if (at.word >= kBankWords) continue;
    ASSERT_EQ(port_place(at.bank, at.word).byte, byte);
    ++words;
  }
  EXPECT_GT(words, 1'000'000u);
}

TEST(PortAddress, WordsFollowEachOtherByTheirStride) {
  for (unsigned bank = 0; bank < kBanks; ++bank) {
    for (const std::uint32_t word : {0u, 1234u, kColumnBase, kColumnBase + 99}) {
      const PortPlace here = port_place(bank, word);
      EXPECT_EQ(port_place(bank, word + 1).byte, here.byte + here.stride) << bank << " " << word;
    }
  }
}

}  // namespace
}  // namespace dynrt::host
