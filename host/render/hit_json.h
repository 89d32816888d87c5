// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Hit records as JSON and as a table. The window and the program's reports give the same numbers.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "host/render/frame.h"

namespace dynrt::host {

/// "#rrggbb".
std::string colour_text(std::uint32_t pixel);

/// The hit record of a pixel and its colour; each number as bits and as a value.
nlohmann::ordered_json hit_json(const Frame& frame, unsigned x, unsigned y);

/// The columns of the table below, each a member of hit_json.
inline constexpr std::array kHitColumns = {"x", "y", "hit", "object", "triangle",
                                           "t", "u", "v",   "cosine", "colour"};

/// A line with the names of the columns, then a line of comma-separated values for each pixel.
std::string hit_table(const Frame& frame);

}  // namespace dynrt::host
