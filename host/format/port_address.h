// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Where the words of the banks lie in a memory behind the core's port: the inverse of bank_word of
// units/memory_format.h.
#pragma once

#include <cstdint>

#include "units/memory_format.h"

namespace dynrt::host {

/// Words of a bank that follow each other in it lie `stride` bytes apart in the memory.
struct PortPlace {
  std::uint32_t byte = 0;
  std::uint32_t stride = 4;
};

/// Of a word of a bank. Lists, pixels and hit records are one run each; in banks 0 and 1 nodes end
/// where columns begin, and the upper half of bank 2 holds columns as well.
constexpr PortPlace port_place(unsigned bank, std::uint32_t word) {
  if (bank >= kHitBank) return {kHitsAt + 8 * word + 4 * (bank - kHitBank), 8};
  if (bank == kFrameBank) return {kPixelsAt + 4 * word, 4};
  if (word >= kColumnBase) {
    return {kColumnsAt + kColumnBytes * (word - kColumnBase) + 4 * bank, kColumnBytes};
  }
  if (bank == 2) return {kEntriesAt + kEntryBytes * word, kEntryBytes};
  return {kNodeBytes * word + 4 * bank, kNodeBytes};
}

/// Whether the word behind this one in the memory is the one that a column leaves empty. Who sends
/// a memory over a line sends it too, as zero, which is shorter than to pass over it.
constexpr bool ends_column(unsigned bank, std::uint32_t word) {
  return bank == 2 && word >= kColumnBase;
}

}  // namespace dynrt::host
