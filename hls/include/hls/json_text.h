// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// JSON as text. A whole number has no decimal point, whatever type holds it: CMake and Python take
// 0.0 for another value than 0.
#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace hls {

/// The same value, its whole numbers as integers. Beyond 2^53 a double is no exact count, and
/// stays.
template <class Json>
Json with_whole_numbers(Json json) {
  constexpr double kExact = 9007199254740992.0;
  if (json.is_structured()) {
    for (auto& part : json) part = with_whole_numbers(std::move(part));
  } else if (json.is_number_float()) {
    const auto number = json.template get<double>();
    if (std::abs(number) <= kExact && number == std::trunc(number)) {
      return static_cast<std::int64_t>(number);
    }
  }
  return json;
}

/// One value a line, each level of it `indent` further in, and a line feed at the end.
template <class Json>
std::string json_text(const Json& json, int indent = 2) {
  return with_whole_numbers(json).dump(indent) + "\n";
}

}  // namespace hls
