// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Plans the upload of an image to a board: only bytes that differ from the board's memory, with as
// few bytes on the line as link packets allow. Unchanged bytes between two changes are sent too
// where that is shorter than another packet.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "host/link/link.h"

namespace dynrt::host {

/// Bytes of a link packet that carry no data: flags, header, CRC.
inline constexpr unsigned kFrameOverhead = 2 + kLinkHeaderBytes + kLinkCrcBytes;
inline constexpr unsigned kAnswerOverhead = 2 + kLinkAnswerBytes + kLinkCrcBytes;

/// The cost of memory transfers on the line.
struct LineCost {
  std::size_t frames = 0;
  std::uint64_t carried = 0;  ///< bytes of the memory
  std::uint64_t sent = 0;     ///< bytes on the line, if none is repeated
  double seconds = 0;
};
LineCost upload_cost(std::span<const MemoryBytes> parts, unsigned baud = kLinkBaud);
/// The cost of reading so many consecutive bytes, in beats of this size. The requests go in the
/// other direction at the same time and cost nothing.
LineCost read_cost(std::uint64_t bytes, unsigned beat_bytes, unsigned baud = kLinkBaud);

/// The contents of the board's memory, as far as they are known.
class UploadPlan {
 public:
  /// The parts to send so that the board holds these, in the order of their addresses. Addresses
  /// and lengths are even. From now on the board counts as holding them.
  std::vector<MemoryBytes> changes(std::span<const MemoryBytes> image);
  /// Forgets all contents, as an upload was interrupted.
  void forget() { pages_.clear(); }

 private:
  static constexpr std::uint32_t kPageBytes = 4096;
  struct Page {
    std::array<std::uint8_t, kPageBytes> bytes{};
    std::bitset<kPageBytes / 2> known;  ///< of its halves
  };
  /// Records a half of 16 bits; returns whether the board needs it.
  bool note(std::uint32_t address, std::uint8_t low, std::uint8_t high);
  /// Whether the bytes from `begin` to `end` are known; if so, appends them.
  bool append_known(std::vector<std::uint8_t>& to, std::uint32_t begin, std::uint32_t end) const;

  std::map<std::uint32_t, Page> pages_;  ///< by address / kPageBytes
};

}  // namespace dynrt::host
