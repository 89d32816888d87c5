// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/limits.h"

#include <algorithm>

#include "host/error.h"
#include "host/memory/matrix_numbers.h"

namespace dynrt::host {

namespace {

/// Throws if `needed` exceeds the limit that follows from a key's number of bits.
void check_limit(const Scene& scene, const char* what, std::size_t needed, std::size_t limit,
                 const char* key, unsigned bits, unsigned memory_bits) {
  if (needed <= limit) return;
  if (bits == memory_bits) {
    refuse(
        "scene '{}' needs {} {}, {} more than the {} that the board's memory holds; use fewer or "
        "smaller objects",
        scene.name, needed, what, needed - limit, limit);
  }
  refuse(
      "scene '{}' needs {} {}, {} more than the {} that the core reaches; take a configuration "
      "with more {} than {}",
      scene.name, needed, what, needed - limit, limit, key, bits);
}

}  // namespace

std::size_t lights_used(const Scene& scene, const CoreInfo& core) {
  return std::min<std::size_t>(scene.lights.size(), core.lights);
}

std::size_t boxes_of_instance(const Scene& scene, const CoreInfo& core) {
  return core.tests_world_box() ? 1 + lights_used(scene, core) : 0;
}

TreeSize address_ends(const CoreConfiguration& core) {
  const std::size_t all = std::size_t{1} << core.address_bits;
  return {core.datapath == Datapath::kFast ? all / 2 : all, all};
}

void check_limits(const Scene& scene, const CoreInfo& core, const MemoryPart& part) {
  const TreeSize ends = address_ends(core);
  const auto check = [&](const char* what, std::size_t needed, std::size_t limit) {
    check_limit(scene, what, needed, limit, "address_bits", core.address_bits, kAddressBits);
  };
  check("tree nodes", part.end_node() - 1, ends.nodes - 1);  // node 0 is the null node
  check("list entries", part.end_entry(), ends.items);
}

void check_matrices(const Scene& scene, const CoreInfo& core) {
  std::size_t numbers = 0;
  for (const Mesh& object : scene.objects) {
    numbers += numbers_taken(scene, object, core.triangle_matrix);
  }
  const std::size_t of_instance = core.levels == 1 ? 0 : has_mirrors(scene) ? 2 : 1;
  const std::size_t matrices = matrices_taken(numbers, core.triangle_matrix) +
                               scene.instances.size() * of_instance + 1 + scene.lights.size() +
                               matrices_of_boxes(scene) * boxes_of_instance(scene, core);
  const char* const what =
      core.tests_world_box() ? "matrices (triangles, instances, their boxes, lights and the camera)"
                             : "matrices (triangles, instances, lights and the camera)";
  check_limit(scene, what, std::max(numbers, matrices), std::size_t{1} << core.matrix_bits,
              "matrix_bits", core.matrix_bits, kMatrixBits);
}

std::uint32_t first_colour(const Scene& scene) {
  for (const Mesh& object : scene.objects) {
    if (object.primitives() > 0) return colour_bits(material_of(scene, object, 0).diffuse);
  }
  return 0;
}

void check_colours(const Scene& scene) {
  const std::uint32_t first = first_colour(scene);
  for (const Mesh& object : scene.objects) {
    for (std::size_t i = 0; i < object.primitives(); ++i) {
      const Material& material = material_of(scene, object, i);
      const std::uint32_t colour = colour_bits(material.diffuse);
      if (colour != first) {
        refuse(
            "scene '{}' has surfaces of the colours {:#08x} and {:#08x} (object '{}', 0xBBGGRR), "
            "but the core has one colour for all; take a configuration without one_colour",
            scene.name, first, colour, object.name);
      }
    }
  }
}

const char* missing_primitive(const Scene& scene, const CoreConfiguration& core) {
  for (const Mesh& object : scene.objects) {
    if (!object.triangles.empty() && !core.primitives.triangle) return "triangles";
    if (!object.ellipsoids.empty() && !core.primitives.sphere) return "spheres";
    if (!object.rectangles.empty() && !core.primitives.rectangle) return "rectangles";
  }
  return nullptr;
}

void check_primitives(const Scene& scene, const CoreInfo& core, const std::string& advice) {
  if (const char* missing = missing_primitive(scene, core)) {
    refuse("scene '{}' has {}, but configuration {} cannot hold them; take {}", scene.name, missing,
           core.name, advice);
  }
}

std::optional<double> out_of_range(const MemoryFormat& format, const glm::dmat4x3& matrix) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) {
      if (!format.holds(matrix[c][r])) return matrix[c][r];
    }
  }
  return std::nullopt;
}

}  // namespace dynrt::host
