// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Words of a scene's banks as bytes of a memory behind the core's port (units/memory_format.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/link/link_frame.h"
#include "host/memory/memory.h"

namespace dynrt::host {

/// The bytes of these runs, in the order of their addresses; consecutive ones are together. The
/// word that a matrix column leaves empty is zero, as it is shorter to send than to pass over.
std::vector<MemoryBytes> port_image(std::span<const MemoryRun> runs);

}  // namespace dynrt::host
