// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The path of a packet through both levels of the trees, with the places of the nodes, objects and
// primitives that it meets.
#pragma once

#include <nlohmann/json.hpp>

#include "host/view/full_picture.h"
#include "host/view/loaded_scene.h"

namespace dynrt::host {

/// A list of steps: {"event", "clock" since the packet's begin, "number", "top"}. A node also has
/// the eight corners of its box as "box", x fastest; an object its name and its box; a triangle its
/// "corners". All are in the file's space.
nlohmann::ordered_json way_json(const LoadedScene& loaded, const FullPicture& picture,
                                const PacketWork& packet);

}  // namespace dynrt::host
