// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/link_frame.h"

#include <algorithm>
#include <utility>

namespace dynrt::host {

namespace {

constexpr std::size_t kLongestAnswer = kLinkAnswerBytes + kLinkDataBytes + kLinkCrcBytes;

void append(std::vector<std::uint8_t>& bytes, std::uint32_t value, unsigned count) {
  for (unsigned i = 0; i < count; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

}  // namespace

std::uint32_t link_crc(std::span<const std::uint8_t> bytes) {
  Crc crc = kCrcStart;
  for (const std::uint8_t byte : bytes) crc = crc_step(crc, hls::uint<8>::from(byte));
  return static_cast<std::uint32_t>((~crc).to_u64());
}

void append_framed(std::vector<std::uint8_t>& line, std::vector<std::uint8_t> bytes) {
  append(bytes, link_crc(bytes), kLinkCrcBytes);
  line.push_back(kLinkFlag);
  for (const std::uint8_t byte : bytes) {
    const bool escapes = byte == kLinkFlag || byte == kLinkEscape;
    if (escapes) line.push_back(kLinkEscape);
    line.push_back(escapes ? byte ^ kLinkEscaped : byte);
  }
  line.push_back(kLinkFlag);
}

void append_frame(std::vector<std::uint8_t>& line, const LinkRequestFrame& request) {
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(request.command), request.sequence};
  append(bytes, request.length, 2);
  append(bytes, request.address, 4);
  bytes.insert(bytes.end(), request.data.begin(), request.data.end());
  append_framed(line, std::move(bytes));
}

std::vector<LinkRequestFrame> write_frames(std::span<const MemoryBytes> parts) {
  std::vector<LinkRequestFrame> frames;
  for (const MemoryBytes& part : parts) {
    for (std::size_t at = 0; at < part.bytes.size();) {
      const std::size_t to_border = kLinkDataBytes - (part.address + at) % kLinkDataBytes;
      const std::size_t length = std::min(to_border, part.bytes.size() - at);
      frames.push_back({.command = LinkCommand::kWriteMemory,
                        .length = static_cast<std::uint16_t>(length),
                        .address = static_cast<std::uint32_t>(part.address + at),
                        .data = std::span(part.bytes).subspan(at, length)});
      at += length;
    }
  }
  return frames;
}

std::optional<LinkAnswerFrame> AnswerReader::take(std::uint8_t byte) {
  ++bytes_;
  if (byte == kLinkFlag) return end_frame();
  if (byte == kLinkEscape) {
    escaped_ = true;
    return std::nullopt;
  }
  if (frame_.size() < kLongestAnswer) {
    frame_.push_back(escaped_ ? byte ^ kLinkEscaped : byte);
  } else {
    too_long_ = true;
  }
  escaped_ = false;
  return std::nullopt;
}

std::optional<LinkAnswerFrame> AnswerReader::end_frame() {
  const std::vector<std::uint8_t> frame = std::exchange(frame_, {});
  const bool cut = std::exchange(escaped_, false) || std::exchange(too_long_, false);
  if (frame.empty() && !cut) return std::nullopt;
  constexpr std::size_t kLeast = kLinkAnswerBytes + kLinkCrcBytes;
  if (!cut && frame.size() >= kLeast) {
    const std::span bytes = std::span(frame).first(frame.size() - kLinkCrcBytes);
    std::vector<std::uint8_t> crc;
    append(crc, link_crc(bytes), kLinkCrcBytes);
    const std::size_t length = frame[2] | std::size_t{frame[3]} << 8;
    if (std::ranges::equal(crc, std::span(frame).last(kLinkCrcBytes)) &&
        length == bytes.size() - kLinkAnswerBytes) {
      return LinkAnswerFrame{frame[0], frame[1], {bytes.begin() + kLinkAnswerBytes, bytes.end()}};
    }
  }
  ++bad_frames_;
  return std::nullopt;
}

}  // namespace dynrt::host
