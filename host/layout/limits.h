// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the memory holds and a core reaches of it. All throw UserError with what is needed and what
// there is.
#pragma once

#include <glm/mat4x3.hpp>
#include <optional>

#include "host/format/core_info.h"
#include "host/memory/memory.h"
#include "host/scene/scene.h"

namespace dynrt::host {

/// For a scene that the memory cannot hold, or the core not reach, whatever its trees are: with
/// more triangles, instances, lights and camera than there are matrices.
void check_matrices(const Scene& scene, const CoreInfo& core);
/// The same for a number of matrices.
void check_matrices(const Scene& scene, const CoreInfo& core, std::size_t needed);

/// For more nodes or list entries than there are.
void check_limits(const Scene& scene, const CoreInfo& core, const MemoryPart& part);

/// For a core that has one colour for all.
void check_colours(const Scene& scene);

/// Of the first surface.
std::uint32_t first_colour(const Scene& scene);

/// The name of a kind of primitives that the scene has and the core lacks, or null.
const char* missing_primitive(const Scene& scene, const CoreConfiguration& core);

/// The first element beyond the core's numbers; small ones round to the smallest magnitude.
std::optional<double> out_of_range(const MemoryFormat& format, const glm::dmat4x3& matrix);

}  // namespace dynrt::host
