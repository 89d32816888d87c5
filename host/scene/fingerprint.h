// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Whether two scenes look the same at every time: what an interrupted walk is told by when it goes
// on. Names do not count, nor what was left out.
#pragma once

#include <cstdint>

#include "host/scene/scene.h"

namespace dynrt::host {

/// 64 bits that differ wherever triangles, colours, places, lights or motions do, but for chance.
std::uint64_t fingerprint(const Scene& scene);

}  // namespace dynrt::host
