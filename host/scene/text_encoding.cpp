// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/text_encoding.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace dynrt::host {

namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr char32_t kHighSurrogate = 0xD800, kLowSurrogate = 0xDC00, kSurrogateEnd = 0xE000;

void append_utf8(std::string& text, char32_t c) {
  const auto byte = [&](char32_t bits) { text += static_cast<char>(bits); };
  const auto tail = [&](int shift) { byte(0x80 | (c >> shift & 0x3F)); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0 | c >> 6);
    tail(0);
  } else if (c < 0x10000) {
    byte(0xE0 | c >> 12);
    tail(6);
    tail(0);
  } else {
    byte(0xF0 | c >> 18);
    tail(12);
    tail(6);
    tail(0);
  }
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t at) -> char32_t {
    const auto first = static_cast<std::uint8_t>(bytes[at]);
    const auto second = static_cast<std::uint8_t>(bytes[at + 1]);
    return big_endian ? first << 8 | second : second << 8 | first;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    char32_t c = unit(at);
    if (c >= kHighSurrogate && c < kSurrogateEnd) {
      const char32_t low = at + 3 < bytes.size() ? unit(at + 2) : 0;
      if (c < kLowSurrogate && low >= kLowSurrogate && low < kSurrogateEnd) {
        c = 0x10000 + ((c - kHighSurrogate) << 10) + (low - kLowSurrogate);
        at += 2;
      } else {
        c = kReplacement;
      }
    }
    append_utf8(text, c);
  }
  return text;
}

}  // namespace

std::string to_utf8(std::string text) {
  if (text.starts_with("\xEF\xBB\xBF")) return text.substr(3);
  if (text.starts_with("\xFF\xFE")) return from_utf16(std::string_view(text).substr(2), false);
  if (text.starts_with("\xFE\xFF")) return from_utf16(std::string_view(text).substr(2), true);
  return text;
}

}  // namespace dynrt::host
