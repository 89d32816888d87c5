// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Words and numbers between the command line and the program.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "host/words.h"

namespace dynrt::host {

/// Parses the whole of `text` as a number; false if it is none.
template <class N>
bool parse(std::string_view text, N& number) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && rest == end;
}

/// Parses numbers with this character between them; false if they are others or not so many.
template <class N, std::size_t kCount>
bool parse_list(std::string_view text, char separator, std::array<N, kCount>& numbers) {
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::size_t end = i + 1 < kCount ? text.find(separator) : text.size();
    if (end == text.npos || !parse(text.substr(0, end), numbers[i])) return false;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

/// Prints on stdout; throws UserError where that cannot be written.
void say(const std::string& text);

}  // namespace dynrt::host
