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
