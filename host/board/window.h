// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The window into the banks on the board's bus (rtl/board/dynrt_registers.vh).
#pragma once

#include <cstdint>

#include "host/board/registers.h"
#include "units/memory_format.h"

namespace dynrt::host::window {

constexpr std::uint32_t address(unsigned bank, std::uint32_t word) {
  namespace reg = registers;
  return 1u << reg::kWindowBit | bank << reg::kWindowBankLow | word << reg::kWindowWordLow;
}
constexpr bool holds(std::uint32_t address) { return (address >> registers::kWindowBit & 1) != 0; }
constexpr unsigned bank(std::uint32_t address) { return address >> registers::kWindowBankLow & 7; }
constexpr std::uint32_t word(std::uint32_t address) {
  return address >> registers::kWindowWordLow & (kBankWords - 1);
}

}  // namespace dynrt::host::window
