// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Words of a scene's banks as bytes of a memory behind the core's port (units/memory_format.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/link/link_frame.h"
#include "host/memory/memory.h"

namespace dynrt::host {

/// The bytes of words by the addresses of their first, in the order of these; consecutive ones are
/// together.
template <class Words>
std::vector<MemoryBytes> bytes_of(const Words& words) {
  std::vector<MemoryBytes> parts;
  for (const auto& [address, word] : words) {
    if (parts.empty() || parts.back().address + parts.back().bytes.size() != address) {
      parts.push_back({address, {}});
    }
    for (unsigned shift = 0; shift < 32; shift += 8) {
      parts.back().bytes.push_back(static_cast<std::uint8_t>(word >> shift));
    }
  }
  return parts;
}

/// The bytes of these runs, in the order of their addresses; consecutive ones are together. The
/// word that a matrix column leaves empty is zero.
std::vector<MemoryBytes> port_image(std::span<const MemoryRun> runs);

}  // namespace dynrt::host
