// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The sizes of the memory and of the part that a core reaches. All functions throw UserError with
// the size that the scene needs and the size that there is.
#pragma once

#include <glm/mat4x3.hpp>
#include <optional>
#include <string>

#include "host/format/core_info.h"
#include "host/memory/memory.h"
#include "host/scene/scene.h"
#include "host/tree/tree.h"

namespace dynrt::host {

/// Throws if the scene has more triangles, instances, lights and cameras than the memory or the
/// core has matrices; then no tree can make it fit.
void check_matrices(const Scene& scene, const CoreInfo& core);

/// The number of the scene's lights whose rays the core traces.
std::size_t lights_used(const Scene& scene, const CoreInfo& core);
/// The boxes that each instance has in the memory. If the core tests boxes, there is one as seen
/// from the eye and one as seen from each of those lights.
std::size_t boxes_of_instance(const Scene& scene, const CoreInfo& core);

/// The ends of the addresses that a core has for nodes and list entries.
TreeSize address_ends(const CoreConfiguration& core);
/// Throws for more nodes or list entries than that.
void check_limits(const Scene& scene, const CoreInfo& core, const MemoryPart& part);

/// Throws if the surfaces have more than one colour; for a core that has one colour for all.
void check_colours(const Scene& scene);

/// The colour of the first surface.
std::uint32_t first_colour(const Scene& scene);

/// The name of a kind of primitives that the scene has and the core lacks, or null.
const char* missing_primitive(const Scene& scene, const CoreConfiguration& core);
/// Throws for such a kind. `advice` names configurations that have it.
void check_primitives(
    const Scene& scene, const CoreInfo& core,
    const std::string& advice = "a configuration whose key primitives lists them");

/// The first element beyond the core's numbers; small ones round to the smallest magnitude.
std::optional<double> out_of_range(const MemoryFormat& format, const glm::dmat4x3& matrix);

}  // namespace dynrt::host
