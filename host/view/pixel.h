// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One pixel of a frame in numbers.
#pragma once

#include <nlohmann/json.hpp>

#include "host/view/full_picture.h"
#include "host/view/loaded_scene.h"

namespace dynrt::host {

/// Its hit record with the names of what is hit, the true hit, and its packet; if `way`, the path
/// of the packet too. Parts that are not known are null. Places are in the file's space.
nlohmann::ordered_json pixel_json(const LoadedScene& loaded, const FullPicture& picture, unsigned x,
                                  unsigned y, bool way = true);

}  // namespace dynrt::host
