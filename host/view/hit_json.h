// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The hit record of a pixel in numbers, the same in the window and in the reports of the program.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "host/render/frame.h"

namespace dynrt::host {

/// With its colour; each number as bits and as a value.
/// "#rrggbb".
std::string colour_text(std::uint32_t pixel);

nlohmann::ordered_json hit_json(const Frame& frame, unsigned x, unsigned y);

}  // namespace dynrt::host
