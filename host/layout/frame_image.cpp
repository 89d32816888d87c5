// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/layout/frame_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <span>

#include "host/error.h"
#include "host/layout/limits.h"
#include "host/layout/tree_image.h"
#include "host/memory/matrix_numbers.h"
#include "host/tree/instance_tree.h"

namespace dynrt::host {

namespace {

/// A light as units/light_columns.h reads it: position in columns 2 and 3, intensity in column 0,
/// the colour in its spare bytes.
MatrixColumns light_columns(const PointLight& light) {
  const double intensity = std::max({light.colour.x, light.colour.y, light.colour.z, 0.0});
  glm::dmat4x3 matrix(0.0);
  matrix[0][0] = intensity;
  matrix[2] = matrix[3] = light.position;
  return to_columns(matrix, intensity > 0 ? colour_bits(light.colour / intensity) : 0);
}

/// Where rays from the camera enter an object's tree.
std::uint32_t entry_of(const ObjectImage::Object& object, const glm::dvec3& eye) {
  return object.box.holds(eye) ? object.root : object.clipped_root;
}

/// Of the only object of a core of one level.
std::uint32_t root_of_all(const Scene& scene, const ObjectImage& objects, const Camera& camera) {
  if (scene.instances.size() != 1) {
    refuse(
        "scene '{}' has {} instances, but the core's trees have one level and hold one object; "
        "take a configuration with levels 2",
        scene.name, scene.instances.size());
  }
  const Instance& instance = scene.instances[0];
  if (instance.transform != glm::dmat4(1.0)) {
    refuse(
        "scene '{}': instance '{}' moves, turns or scales its object, but the core's trees have "
        "one level and cannot move an object; take a configuration with levels 2",
        scene.name, instance.name);
  }
  return entry_of(objects.objects.at(instance.object), camera.position);
}

/// An instance's box in the world is larger than the instance by this many roundings of the
/// farthest coordinate, as a ray is not quite in the object where it is in the world: the matrix
/// and five operations on each coordinate are rounded.
constexpr double kBoxRoundings = 16;

/// The box as the core tests it (units/world_box.h), for rays from the eye or a light.
MemoryColumn box_column_of(const MemoryFormat& format, const Aabb& box, const glm::dvec3& from) {
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double x : {box.low[axis], box.high[axis], from[axis]}) {
      farthest = std::max(farthest, std::abs(x));
    }
  }
  const double rounding = std::ldexp(1.0, -static_cast<int>(format.mantissa_bits) - 1);
  const double margin = kBoxRoundings * rounding * farthest;
  std::array<double, 3> low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const double start = format.round(from[axis]);
    low[axis] = box.low[axis] - margin - start;
    high[axis] = box.high[axis] + margin - start;
  }
  return format.box_column(low, high);
}

/// The core clips the rays of an object to its box in the world. If that is larger than the
/// object's own by more than this, which is turned with it, the six clipping nodes save more steps
/// than they take.
constexpr double kLooseBox = 1.3;

double volume(const Aabb& box) {
  const glm::dvec3 extent = box.extent();
  return extent.x * extent.y * extent.z;
}

/// Whether the box in the world clips the rays of an instance well enough without those nodes.
bool is_tight(const Instance& instance, const Aabb& box) {
  const double scale = std::abs(glm::determinant(glm::dmat3(instance.transform)));
  return volume(transformed_box(box, instance.transform)) <= kLooseBox * scale * volume(box);
}

/// Appends the boxes of all instances as they lie from a point, as far apart as their matrices.
void add_boxes(MemoryPart& part, const Scene& scene, const ObjectImage& objects,
               const glm::dvec3& from) {
  const std::uint32_t stride = has_mirrors(scene) ? 2 : 1;
  for (const Instance& instance : scene.instances) {
    const Aabb box = transformed_box(objects.objects.at(instance.object).box, instance.transform);
    part.columns.push_back(box_column_of(*part.format, box, from));
    part.columns.resize(part.columns.size() + stride - 1);
  }
}

/// Where the camera's rays start, and then those that have met the main object.
struct Starts {
  std::uint32_t first = 0, others = 0;
};

/// Appends the tree of instances and their matrices, whose first is the next.
Starts add_instances(MemoryPart& part, const Scene& scene, const ObjectImage& objects,
                     const Tree& instances, const Camera& camera) {
  const MemoryFormat& format = *part.format;
  const std::uint32_t stride = has_mirrors(scene) ? 2 : 1;
  const std::uint32_t first = part.end_matrix();
  std::vector<std::uint32_t> matrix_of(scene.instances.size());
  for (std::uint32_t i = 0; i < matrix_of.size(); ++i) matrix_of[i] = first + stride * i;
  const auto address = add_tree(part, instances, objects.core, matrix_of, nullptr);
  check_limits(scene, objects.core, part);
  part.columns.reserve(4 * (stride * scene.instances.size() + 1 + scene.lights.size()));
  for (const Instance& instance : scene.instances) {
    const glm::dmat4 inverse = glm::inverse(instance.transform);
    const ObjectImage::Object& object = objects.objects.at(instance.object);
    // A zero of either sign is the positive one.
    const glm::dmat4x3 matrix = glm::dmat4x3(inverse) + 0.0;
    if (!std::isfinite(inverse[3][3]) || glm::determinant(instance.transform) == 0) {
      refuse(
          "instance '{}' has a transform without an inverse; the transform must not flatten its "
          "object",
          instance.name);
    }
    if (const auto element = out_of_range(format, matrix)) {
      refuse(
          "instance '{}': the inverse of its transform has the element {:g}, outside the core's "
          "numbers (-{:.5g} to {:.5g}); let the transform flatten or shrink its object less",
          instance.name, *element, format.largest, format.largest);
    }
    const glm::dvec3 eye(inverse * glm::dvec4(camera.position, 1.0));
    const bool clipped = objects.core.tests_world_box() && is_tight(instance, object.box);
    part.add(to_columns(matrix, clipped ? object.root : entry_of(object, eye)));
    if (stride == 2) {
      part.add(to_columns(glm::dmat4x3(instance.transform) + 0.0, 0));
    }
  }
  const std::uint32_t entry = address[instances.entry(camera.position)];
  if (instances.main_leaf == kNullNode) return {entry, 0};
  return {address[instances.main_leaf], entry};
}

}  // namespace

FrameImage::FrameImage(const Scene& scene, const ObjectImage& objects, const Tree& instances,
                       const Camera& camera, unsigned width, unsigned height) {
  const MemoryFormat& format = *objects.memory.format;
  const double largest = format.largest;
  memory.format = &format;
  memory.first_node = objects.memory.end_node();
  memory.first_entry = objects.memory.end_entry();
  first_instance = objects.memory.end_matrix();
  memory.first_column = 4 * first_instance;
  colour = first_colour(scene);
  lights = static_cast<unsigned>(scene.lights.size());
  if (objects.core.levels == 1) {
    start_node = root_of_all(scene, objects, camera);
  } else {
    const Starts starts = add_instances(memory, scene, objects, instances, camera);
    start_node = starts.first;
    others_node = starts.others;
  }
  const glm::dmat4x3 from_pixels = dynrt::host::camera_matrix(camera, width, height);
  if (const auto element = out_of_range(format, from_pixels)) {
    refuse(
        "the camera's matrix has the element {:g}, outside the core's numbers (-{:.5g} to {:.5g}); "
        "move the camera closer to the scene",
        *element, largest, largest);
  }
  camera_matrix = memory.end_matrix();
  memory.add(to_columns(from_pixels, 0));
  light_matrix = memory.end_matrix();
  for (const PointLight& light : scene.lights) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!format.holds(light.position[axis])) {
        refuse(
            "light '{}' stands at {} = {:g}, outside the core's numbers (-{:.5g} to {:.5g}); move "
            "it closer to the scene",
            light.name, static_cast<char>('x' + axis), light.position[axis], largest, largest);
      }
    }
    memory.add(light_columns(light));
  }
  if (objects.core.tests_world_box()) {
    box_column = memory.end_column() - first_instance;
    add_boxes(memory, scene, objects, camera.position);
    boxes_apart = memory.end_column() - first_instance - box_column;
    for (const PointLight& light :
         std::span(scene.lights).first(lights_used(scene, objects.core))) {
      add_boxes(memory, scene, objects, light.position);
    }
  }
}

double MemoryUse::tree_megabytes() const {
  return word_bytes * (2.0 * static_cast<double>(nodes) + static_cast<double>(list_entries)) / 1e6;
}

double MemoryUse::matrix_megabytes() const {
  return word_bytes * 12.0 * static_cast<double>(matrices) / 1e6;
}

MemoryUse memory_use(const FrameImage& frame) {
  return {frame.memory.end_node(), frame.memory.end_entry(), frame.memory.end_matrix(),
          frame.memory.format->word_bits / 8.0};
}

glm::dmat4x3 camera_matrix(const Camera& camera, unsigned width, unsigned height) {
  const glm::dvec3 across = camera.right / static_cast<double>(width);
  const glm::dvec3 down = -camera.up / static_cast<double>(height);
  const glm::dvec3 corner = camera.forward - 0.5 * camera.right + 0.5 * camera.up;
  return {across, down, corner + 0.5 * across + 0.5 * down, camera.position};
}

}  // namespace dynrt::host
