// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The use of the units, FIFOs and caches in a frame that was watched, over the whole frame and over
// time.
#pragma once

#include <nlohmann/json.hpp>

#include "host/view/full_picture.h"

namespace dynrt::host {

/// `clock`: of the core, {"mhz": ..}.
nlohmann::ordered_json machine_json(const FullPicture& picture,
                                    const nlohmann::ordered_json& clock);

}  // namespace dynrt::host
