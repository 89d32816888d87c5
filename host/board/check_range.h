// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "host/board/messages.h"
#include "host/board/sram.h"

namespace dynrt::host {

/// A transfer outside a bank is a defect of the host, not of the user's input.
inline void check_range(const std::string& board, unsigned bank, std::uint32_t address,
                        std::size_t words) {
  if (bank < Sram::kBanks && address <= Sram::kWords && words <= Sram::kWords - address) return;
  throw std::out_of_range(fmt::format(messages::kOutsideBank, board, address, address + words, bank,
                                      Sram::kBanks, Sram::kWords));
}

}  // namespace dynrt::host
