// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tells whether two scenes look the same at every time, so that an interrupted walk can continue.
// Names and left-out primitives do not count.
#pragma once

#include <cstdint>

#include "host/scene/scene.h"

namespace dynrt::host {

/// 64 bits that almost certainly differ if triangles, colours, places, lights or motions differ.
std::uint64_t fingerprint(const Scene& scene);

}  // namespace dynrt::host
