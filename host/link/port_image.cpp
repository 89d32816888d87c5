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
      const std::uint32_t address = port_place(run.bank, run.address + i).byte;
      words.emplace_back(address, run.words[i]);
      const bool ends_column = run.bank == 2 && run.address + i >= kColumnBase;
      if (ends_column) words.emplace_back(address + 4, 0);
    }
  }
  std::ranges::sort(words);
  std::vector<MemoryBytes> image;
  for (const auto& [address, word] : words) {
    if (image.empty() || image.back().address + image.back().bytes.size() != address) {
      image.push_back({address, {}});
    }
    for (unsigned i = 0; i < 4; ++i) {
      image.back().bytes.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
    }
  }
  return image;
}

}  // namespace dynrt::host
