// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What has to be sent so that a board's memory holds an image: the bytes that the board does not
// hold yet, in as few bytes on the line as frames allow. Bytes between two changes go along where
// that is shorter than another frame.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "host/link/link.h"

namespace dynrt::host {

/// Bytes of a frame that carry no data: flags, header, CRC.
inline constexpr unsigned kFrameOverhead = 2 + kLinkHeaderBytes + kLinkCrcBytes;
inline constexpr unsigned kAnswerOverhead = 2 + kLinkAnswerBytes + kLinkCrcBytes;

/// What memory costs on the line.
struct LineCost {
  std::size_t frames = 0;
  std::uint64_t carried = 0;  ///< bytes of the memory
  std::uint64_t sent = 0;     ///< bytes on the line, if none is repeated
  double seconds = 0;
};
LineCost upload_cost(std::span<const MemoryBytes> parts, unsigned baud = kLinkBaud);
/// Of so many bytes that are read one after another, in beats of this size. Requests go the other
/// way meanwhile and take no time.
LineCost read_cost(std::uint64_t bytes, unsigned beat_bytes, unsigned baud = kLinkBaud);

/// What the board's memory holds, as far as it is known.
class UploadPlan {
 public:
  /// The parts to send so that the board holds these, in the order of their addresses. Addresses
  /// and lengths are even. From now on the board counts as holding them.
  std::vector<MemoryBytes> changes(std::span<const MemoryBytes> image);
  /// Nothing is known any more: an upload was interrupted.
  void forget() { pages_.clear(); }

 private:
  static constexpr std::uint32_t kPageBytes = 4096;
  struct Page {
    std::array<std::uint8_t, kPageBytes> bytes{};
    std::bitset<kPageBytes / 2> known;  ///< of its halves
  };
  /// Notes a half; tells whether the board has to be told.
  bool note(std::uint32_t address, std::uint8_t low, std::uint8_t high);
  /// Whether the bytes from `begin` to `end` are known; if so, appends them.
  bool append_known(std::vector<std::uint8_t>& to, std::uint32_t begin, std::uint32_t end) const;

  std::map<std::uint32_t, Page> pages_;  ///< by address / kPageBytes
};

}  // namespace dynrt::host
