// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The banks as a memory behind the core's port sees them (units/memory_format.h).
#pragma once

#include <cstdint>

#include "host/board/sram.h"

namespace dynrt::host {

/// Zero where the memory holds nothing.
inline std::uint8_t port_byte(const Sram& sram, unsigned byte) {
  const BankWord at = bank_word(byte);
  const std::uint32_t word = at.bank == kBanks ? 0 : sram.word(at.bank, at.word);
  return static_cast<std::uint8_t>(word >> (8 * (byte % 4)));
}
inline void write_port_half(Sram& sram, unsigned byte, std::uint16_t half) {
  const BankWord at = bank_word(byte);
  sram.write_half(at.bank, at.word, byte / 2 % 2, half);
}

}  // namespace dynrt::host
