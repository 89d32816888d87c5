// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <vector>

#include "host/error.h"
#include "host/format/memory_format_of.h"

namespace dynrt::host {

namespace {

/// Small enough that values computed from a flag stay within the shipped core's numbers. lay_out()
/// refuses values that another core cannot hold.
const double kLargest = std::sqrt(kShippedFormat.largest);

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

void say(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    refuse("cannot print the report ({}); free some space or redirect the output to another place",
           std::strerror(errno));
  }
}

std::pair<unsigned, unsigned> parse_size(const std::string& text) {
  const auto parts = split(text, 'x');
  std::pair<unsigned, unsigned> size;
  if (parts.size() != 2 || !parse(parts[0], size.first) || !parse(parts[1], size.second)) {
    refuse("--size {}: write WIDTHxHEIGHT in pixels, for example 512x384", text);
  }
  return size;
}

glm::dvec3 parse_vector(const std::string& flag, const std::string& text) {
  const auto parts = split(text, ',');
  glm::dvec3 vector;
  if (parts.size() != 3 || !parse(parts[0], vector.x) || !parse(parts[1], vector.y) ||
      !parse(parts[2], vector.z)) {
    refuse("{} {}: write three numbers separated by commas, for example 1,2.5,-3", flag, text);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(vector[axis]) <= kLargest)) {
      refuse("{} {}: the numbers must lie within -{:.3g} and {:.3g}", flag, text, kLargest,
             kLargest);
    }
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
