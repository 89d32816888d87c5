// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The report of a frame, as lines of text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/app/core_clock.h"
#include "host/render/compare.h"
#include "host/render/figures.h"

namespace dynrt::host {

std::string report_text(const Frame& frame, const FrameFigures& figures, const CoreClock& clock);
nlohmann::ordered_json report_json(const Frame& frame, const FrameFigures& figures,
                                   const CoreClock& clock);

std::string comparison_text(const Comparison& comparison, const std::string& left,
                            const std::string& right);
nlohmann::ordered_json comparison_json(const Comparison& comparison);

}  // namespace dynrt::host
