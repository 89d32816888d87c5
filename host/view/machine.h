// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The machine in a frame that was watched: the use of its units and caches, over the whole frame
// and in the course of it.
#pragma once

#include <nlohmann/json.hpp>

#include "host/view/still.h"

namespace dynrt::host {

/// `clock`: of the core, {"mhz": ..}.
nlohmann::ordered_json machine_json(const Still& still, const nlohmann::ordered_json& clock);

}  // namespace dynrt::host
