// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Requests as bytes on the line, and answers from them (units/link_format.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "units/link_format.h"

namespace dynrt::host {

struct LinkRequestFrame {
  LinkCommand command = LinkCommand::kIdentify;
  std::uint8_t sequence = 0;
  std::uint16_t length = 0;
  std::uint32_t address = 0;
  std::span<const std::uint8_t> data = {};  ///< of a write
};
/// Consecutive bytes of the board's memory.
struct MemoryBytes {
  std::uint32_t address = 0;
  std::vector<std::uint8_t> bytes;
  friend bool operator==(const MemoryBytes&, const MemoryBytes&) = default;
};
/// The requests that write these parts; they point to the bytes of the parts. Each link packet ends
/// where a beat ends.
std::vector<LinkRequestFrame> write_frames(std::span<const MemoryBytes> parts);

struct LinkAnswerFrame {
  std::uint8_t kind = 0;
  std::uint8_t sequence = 0;
  std::vector<std::uint8_t> data;
};

/// The CRC as it is sent.
std::uint32_t link_crc(std::span<const std::uint8_t> bytes);

/// Appends a link packet of these bytes: with their CRC, escapes, and a flag at both ends.
void append_framed(std::vector<std::uint8_t>& line, std::vector<std::uint8_t> bytes);
void append_frame(std::vector<std::uint8_t>& line, const LinkRequestFrame& request);

/// Takes the bytes of the line one by one.
class AnswerReader {
 public:
  /// The answer that ends with this byte, if one does and is undamaged.
  std::optional<LinkAnswerFrame> take(std::uint8_t byte);

  std::uint64_t bytes() const { return bytes_; }
  std::uint64_t bad_frames() const { return bad_frames_; }
  /// Whether the line is within a link packet.
  bool in_frame() const { return !frame_.empty() || escaped_; }

 private:
  std::optional<LinkAnswerFrame> end_frame();

  std::vector<std::uint8_t> frame_;
  bool escaped_ = false;
  bool too_long_ = false;
  std::uint64_t bytes_ = 0;
  std::uint64_t bad_frames_ = 0;
};

}  // namespace dynrt::host
