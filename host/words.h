// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Numbers in a sentence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace dynrt::host {

/// 1234567 as "1,234,567".
inline std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), ",");
  }
  return digits;
}

/// "1 object", "2 objects".
inline std::string counted(std::uint64_t number, const std::string& what) {
  return grouped(number) + " " + what + (number == 1 ? "" : "s");
}

}  // namespace dynrt::host
