// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "host/board/board.h"
#include "units/memory_format.h"

namespace dynrt::host {

/// A transfer outside a bank is a defect of the host, not of the user's input.
inline void check_range(const Board& board, unsigned bank, std::uint32_t address,
                        std::size_t bus_words) {
  const unsigned parts = bank < kSceneBanks ? board.core().format->bus_words() : 1;
  const std::size_t words = (bus_words + parts - 1) / parts;
  if (bank < kBanks && address <= kBankWords && words <= kBankWords - address) return;
  throw std::out_of_range(fmt::format(
      "board {}: there are no words {} to {} of bank {}; the board has {} banks of {} words",
      board.name(), address, address + words, bank, kBanks, kBankWords));
}

}  // namespace dynrt::host
