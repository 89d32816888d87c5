// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The way of a packet through both levels of the trees, with the places of what it comes to.
#pragma once

#include <nlohmann/json.hpp>

#include "host/view/scenery.h"
#include "host/view/still.h"

namespace dynrt::host {

/// A list of steps: {"event", "clock" since the packet's begin, "number", "top"}. A node has the
/// eight corners of its box as "box", x fastest, an object its name and its box, a triangle its
/// "corners"; all in the file's space.
nlohmann::ordered_json way_json(const Scenery& scenery, const Still& still,
                                const PacketWork& packet);

}  // namespace dynrt::host
