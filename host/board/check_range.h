// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "host/board/messages.h"
#include "units/memory_format.h"

namespace dynrt::host {

/// A transfer outside a bank is a defect of the host, not of the user's input.
inline void check_range(const std::string& board, unsigned bank, std::uint32_t address,
                        std::size_t words) {
  if (bank < kBanks && address <= kBankWords && words <= kBankWords - address) return;
  throw std::out_of_range(fmt::format(messages::kOutsideBank, board, address, address + words, bank,
                                      kBanks, kBankWords));
}

}  // namespace dynrt::host
