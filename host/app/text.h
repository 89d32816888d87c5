// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Words and numbers between the command line and the program.
#pragma once

#include <charconv>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace dynrt::host {

/// Parses the whole of `text` as a number; false if it is none.
template <class N>
bool parse(std::string_view text, N& number) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && rest == end;
}

/// Prints on stdout; throws UserError where that cannot be written.
void say(const std::string& text);
/// "512x384" as two numbers; throws UserError.
std::pair<unsigned, unsigned> parse_size(const std::string& text);
/// "1,2.5,-3" as a vector; throws UserError that names the flag.
glm::dvec3 parse_vector(const std::string& flag, const std::string& text);
/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);
/// "1 object", "2 objects".
std::string counted(std::uint64_t number, const std::string& what);

}  // namespace dynrt::host
