// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/text.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <vector>

#include "host/app/messages.h"
#include "host/error.h"

namespace dynrt::host {

namespace {

/// The whole of `text` as a number, or false.
template <class N>
bool parse(std::string_view text, N& number) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && rest == end;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

std::pair<unsigned, unsigned> parse_size(const std::string& text) {
  const auto parts = split(text, 'x');
  std::pair<unsigned, unsigned> size;
  if (parts.size() != 2 || !parse(parts[0], size.first) || !parse(parts[1], size.second)) {
    refuse(messages::kSizeText, text);
  }
  return size;
}

glm::dvec3 parse_vector(const std::string& flag, const std::string& text) {
  const auto parts = split(text, ',');
  glm::dvec3 vector;
  if (parts.size() != 3 || !parse(parts[0], vector.x) || !parse(parts[1], vector.y) ||
      !parse(parts[2], vector.z)) {
    refuse(messages::kVectorText, flag, text);
  }
  return vector;
}

std::string grouped(std::uint64_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), ",");
  }
  return digits;
}

std::string counted(std::uint64_t number, const std::string& what) {
  return grouped(number) + " " + what + (number == 1 ? "" : "s");
}

}  // namespace dynrt::host
