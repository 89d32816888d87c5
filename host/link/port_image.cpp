// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/port_image.h"

#include <algorithm>
#include <utility>

#include "host/format/port_address.h"

namespace dynrt::host {

std::vector<MemoryBytes> port_image(std::span<const MemoryRun> runs) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> words;  // address, word
  for (const MemoryRun& run : runs) {
    for (std::uint32_t i = 0; i < run.words.size(); ++i) {
      const std::uint32_t word = run.address + i;
      const std::uint32_t address = port_place(run.bank, word).byte;
      words.emplace_back(address, run.words[i]);
      if (ends_column(run.bank, word)) words.emplace_back(address + 4, 0);
    }
  }
  std::ranges::sort(words);
  return bytes_of(words);
}

}  // namespace dynrt::host
