// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One pixel of a frame in numbers.
#pragma once

#include <nlohmann/json.hpp>

#include "host/view/scenery.h"
#include "host/view/still.h"

namespace dynrt::host {

/// Its hit record with the names of what is hit, the truth beside it, and the way of its packet, as
/// far as they are known. Places are in the file's space. `way`: with the way.
nlohmann::ordered_json pixel_json(const Scenery& scenery, const Still& still, unsigned x,
                                  unsigned y, bool way = true);

}  // namespace dynrt::host
