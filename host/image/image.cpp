// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/image/image.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>

#include "host/error.h"
#include "host/image/messages.h"
#include "host/tree/triangle_matrix.h"

namespace dynrt::host {

namespace {

constexpr char kMatrices[] = "matrices (triangles, instances, lights and the camera)";
constexpr double kFlattestBox = 1.0 / 1024;  ///< thickness of a box by its longest side
constexpr double kBoxMargin = 1.0 / 4096;    ///< around an object's box, by its side

/// How much a material reflects, in 256ths; of what reflects at all neither none nor all of it.
std::uint32_t mirror_part(const Material& material) {
  if (!(material.mirror > 0)) return 0;
  return static_cast<std::uint32_t>(std::clamp(std::lround(256 * material.mirror), 1L, 255L));
}

/// Of the numbers that `bits` can tell apart, the first `unused` are nobody's.
void check_limit(const Scene& scene, const char* what, std::size_t needed, const char* key,
                 unsigned bits, unsigned memory_bits, std::size_t unused = 0) {
  const std::size_t limit = (std::size_t{1} << bits) - unused;
  if (needed <= limit) return;
  if (bits == memory_bits) {
    refuse(messages::kTooMany, scene.name, needed, what, needed - limit, limit);
  }
  refuse(messages::kOutOfReach, scene.name, needed, what, needed - limit, limit, key, bits);
}

void check_matrices(const Scene& scene, const ImageForm& form, std::size_t needed) {
  check_limit(scene, kMatrices, needed, "matrix_bits", form.matrix_bits, kMatrixBits);
}

void check_limits(const Scene& scene, const ImageForm& form, const MemoryPart& part) {
  constexpr char kKey[] = "address_bits";
  check_limit(scene, "tree nodes", part.end_node() - 1, kKey, form.address_bits, kAddressBits, 1);
  check_limit(scene, "list entries", part.end_entry(), kKey, form.address_bits, kAddressBits);
}

/// The first element beyond the core's numbers; small ones round to the smallest magnitude.
std::optional<double> out_of_range(const MemoryFormat& format, const glm::dmat4x3& matrix) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 3; ++r) {
      if (!format.holds(matrix[c][r])) return matrix[c][r];
    }
  }
  return std::nullopt;
}

const Material& material_of(const Scene& scene, const Mesh& object, std::size_t primitive) {
  return scene.materials.at(object.material_of(primitive));
}

std::uint32_t first_colour(const Scene& scene) {
  for (const Mesh& object : scene.objects) {
    if (object.primitives() > 0) return colour_bits(material_of(scene, object, 0).diffuse);
  }
  return 0;
}

/// For a core that has one colour for all.
void check_colours(const Scene& scene) {
  const std::uint32_t first = first_colour(scene);
  for (const Mesh& object : scene.objects) {
    for (std::size_t i = 0; i < object.primitives(); ++i) {
      const Material& material = material_of(scene, object, i);
      const std::uint32_t colour = colour_bits(material.diffuse);
      if (colour != first) refuse(messages::kColours, scene.name, first, colour, object.name);
    }
  }
}

/// A sphere is none: each of its points would need a reflection of its own.
bool is_mirror(const Scene& scene, const Mesh& object, std::size_t primitive) {
  return !object.is_ellipsoid(primitive) && material_of(scene, object, primitive).mirror > 0;
}

Primitive kind_of(const Mesh& object, std::size_t primitive) {
  return object.is_ellipsoid(primitive)   ? Primitive::kSphere
         : object.is_rectangle(primitive) ? Primitive::kRectangle
                                          : Primitive::kTriangle;
}

/// Columns from one primitive's number to the next.
std::uint32_t columns_apart(TriangleMatrix form) {
  return form == TriangleMatrix::kMemoryEfficient ? kStoredColumns : 4;
}

bool stored_in_three(const Mesh& object, std::size_t primitive, TriangleMatrix form) {
  return form == TriangleMatrix::kMemoryEfficient && !object.is_ellipsoid(primitive);
}

/// Numbers that a primitive takes: one, and those that its fourth column or its reflection, a
/// matrix of four columns at the next number, reach into.
std::uint32_t numbers_of(const Scene& scene, const Mesh& object, std::size_t primitive,
                         TriangleMatrix form) {
  const bool mirror = is_mirror(scene, object, primitive);
  if (form == TriangleMatrix::kNormalConsistent) return mirror ? 2 : 1;
  return mirror ? 3 : object.is_ellipsoid(primitive) ? 2 : 1;
}

/// Takes a ray to the ray that the triangle's plane reflects: x - 2 n (n . x - n . c).
glm::dmat4x3 reflection_matrix(const std::array<glm::dvec3, 3>& triangle) {
  const glm::dvec3 n =
      glm::normalize(glm::cross(triangle[0] - triangle[2], triangle[1] - triangle[2]));
  glm::dmat4x3 matrix;
  for (int c = 0; c < 3; ++c) {
    matrix[c] = -2.0 * n[c] * n;
    matrix[c][c] += 1.0;
  }
  matrix[3] = 2.0 * glm::dot(n, triangle[2]) * n;
  return matrix;
}

/// A light as units/light_columns.h reads it: position in columns 2 and 3, intensity in column 0,
/// the colour in its spare bytes.
MatrixColumns light_columns(const PointLight& light) {
  const double intensity = std::max({light.colour.x, light.colour.y, light.colour.z, 0.0});
  glm::dmat4x3 matrix(0.0);
  matrix[0][0] = intensity;
  matrix[2] = matrix[3] = light.position;
  return to_columns(matrix, intensity > 0 ? colour_bits(light.colour / intensity) : 0);
}

/// What takes the box to the cube from -1 to 1, a little inwards, as the core's arithmetic may be
/// off by a few steps. A flat box is given a thickness, so that the matrix has an inverse.
glm::dmat4 box_to_cube(const Aabb& box) {
  const glm::dvec3 centre = 0.5 * (box.low + box.high);
  const glm::dvec3 half = 0.5 * (box.high - box.low);
  const double least = std::max({half.x, half.y, half.z}) * kFlattestBox;
  glm::dmat4 matrix(1.0);
  for (int k = 0; k < 3; ++k) {
    matrix[k][k] = 1.0 / (std::max(half[k], least) * (1.0 + kBoxMargin));
    matrix[3][k] = -centre[k] * matrix[k][k];
  }
  return matrix;
}

/// The map of a primitive from the core's space of the object.
UnitMatrix unit_matrix(const ImageForm& form, const Mesh& mesh, std::size_t primitive,
                       const glm::dmat4& from_space, bool three) {
  const MemoryFormat& format = *form.format;
  const double largest = format.largest;
  const bool sphere = mesh.is_ellipsoid(primitive);
  UnitMatrix unit;
  if (sphere) {
    unit = ellipsoid_matrix(mesh.ellipsoid(primitive));
    unit.matrix = unit.matrix * from_space;
  } else {
    const auto matrix = triangle_matrix(mesh.corners(primitive));
    if (!matrix) refuse(messages::kFlatTriangle, mesh.name, primitive);
    const glm::dmat4x3 in_space = *matrix * from_space;
    unit = form.triangle_test == TriangleTest::kWatertight
               ? corner_matrix(mesh.corners(primitive), in_space)
           : three ? efficient_matrix(in_space)
                   : UnitMatrix{in_space};
  }
  if (const auto element = out_of_range(format, unit.matrix)) {
    if (sphere) refuse(messages::kSphereRange, mesh.name, primitive, *element, largest, largest);
    refuse(messages::kTriangleRange, mesh.name, primitive, *element, largest, largest);
  }
  return unit;
}

/// Appends a tree, of an object's primitives or of instances, its planes moved and scaled to a
/// space; item i becomes the matrix matrix_of[i]. Returns the address of the tree's node 0, which
/// has no place itself: node i lies at that address + i.
std::uint32_t add_tree(MemoryPart& part, const Tree& tree, std::span<const std::uint32_t> matrix_of,
                       const Mesh* object, const glm::dmat4& to_space = glm::dmat4(1.0)) {
  const std::uint32_t base = part.end_node() - 1;
  const std::uint32_t list_base = part.end_entry();
  const auto child = [&](std::uint32_t index) { return index == kNullNode ? 0 : base + index; };
  part.nodes.reserve(part.nodes.size() + tree.nodes.size());
  for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
    const TreeNode& from = tree.nodes[i];
    MemoryNode node;
    node.kind = static_cast<NodeKind>(from.axis);
    if (from.is_leaf()) {
      node.left = list_base + from.left;
    } else {
      const int k = from.axis;
      node.split = to_space[k][k] * from.split + to_space[3][k];
      node.left = child(from.left);
      node.right = child(from.right);
    }
    part.nodes.push_back(node);
  }
  const std::size_t first = part.entries.size();
  for (const std::uint32_t item : tree.items) {
    ListEntry entry;
    entry.matrix = MatrixIndex::from(matrix_of[item]);
    if (object != nullptr) entry.set_primitive(kind_of(*object, item));
    part.entries.push_back(entry);
  }
  for (const TreeNode& node : tree.nodes) {
    if (node.is_leaf() && node.right > 0) {
      part.entries[first + node.left + node.right - 1].last = true;
    }
  }
  return base;
}

/// Where rays from the camera enter an object's tree.
std::uint32_t entry_of(const ObjectImage::Object& object, const glm::dvec3& eye) {
  return object.box.holds(eye) ? object.root : object.clipped_root;
}

/// Of the only object of a core of one level.
std::uint32_t root_of_all(const Scene& scene, const ObjectImage& objects, const Camera& camera) {
  if (scene.instances.size() != 1) {
    refuse(messages::kOneObject, scene.name, scene.instances.size());
  }
  const Instance& instance = scene.instances[0];
  if (instance.transform != glm::dmat4(1.0)) {
    refuse(messages::kNotAsItIs, scene.name, instance.name);
  }
  return entry_of(objects.objects.at(instance.object), camera.position);
}

/// Appends the tree of instances and their matrices, whose first is the next. Returns the node
/// where the camera's rays start.
std::uint32_t add_instances(MemoryPart& part, const Scene& scene, const ObjectImage& objects,
                            const Tree& instances, const Camera& camera) {
  const MemoryFormat& format = *part.format;
  const std::uint32_t stride = has_mirrors(scene) ? 2 : 1;
  const std::uint32_t first = part.end_matrix();
  std::vector<std::uint32_t> matrix_of(scene.instances.size());
  for (std::uint32_t i = 0; i < matrix_of.size(); ++i) matrix_of[i] = first + stride * i;
  const std::uint32_t base = add_tree(part, instances, matrix_of, nullptr);
  check_limits(scene, objects.form, part);
  check_matrices(scene, objects.form, first + stride * scene.instances.size());
  part.columns.reserve(4 * (stride * scene.instances.size() + 1 + scene.lights.size()));
  for (const Instance& instance : scene.instances) {
    const glm::dmat4 inverse = glm::inverse(instance.transform);
    const ObjectImage::Object& object = objects.objects.at(instance.object);
    const glm::dmat4x3 matrix(object.to_space * inverse);
    if (!std::isfinite(inverse[3][3]) || glm::determinant(instance.transform) == 0) {
      refuse(messages::kFlatInstance, instance.name);
    }
    if (const auto element = out_of_range(format, matrix)) {
      refuse(messages::kInstanceRange, instance.name, *element, format.largest, format.largest);
    }
    const glm::dvec3 eye(inverse * glm::dvec4(camera.position, 1.0));
    part.add(to_columns(matrix, entry_of(object, eye)));
    if (stride == 2) {
      const glm::dmat4 back = instance.transform * glm::inverse(object.to_space);
      part.add(to_columns(glm::dmat4x3(back), 0));
    }
  }
  return base + instances.entry(camera.position);
}

}  // namespace

void check_matrices(const Scene& scene, const ImageForm& form) {
  std::size_t numbers = 0;
  for (const Mesh& object : scene.objects) {
    for (std::size_t i = 0; i < object.primitives(); ++i) {
      numbers += numbers_of(scene, object, i, form.triangles);
    }
  }
  const std::size_t of_instance = form.levels == 1 ? 0 : has_mirrors(scene) ? 2 : 1;
  const std::size_t matrices = matrices_taken(numbers, form.triangles) +
                               scene.instances.size() * of_instance + 1 + scene.lights.size();
  check_matrices(scene, form, std::max(numbers, matrices));
}

std::size_t matrices_taken(std::size_t numbers, TriangleMatrix form) {
  return (numbers * columns_apart(form) + 3) / 4;
}

std::vector<std::uint32_t> matrix_numbers(const Scene& scene, const Mesh& object,
                                          std::uint32_t first, TriangleMatrix form) {
  std::vector<std::uint32_t> numbers{first};
  for (std::size_t i = 0; i < object.primitives(); ++i) {
    numbers.push_back(numbers.back() + numbers_of(scene, object, i, form));
  }
  return numbers;
}

ObjectImage::ObjectImage(const Scene& scene, std::span<const Tree> trees, const ImageForm& form)
    : form(form) {
  const std::uint32_t apart = columns_apart(form.triangles);
  check_matrices(scene, form);
  if (form.one_colour) check_colours(scene);
  const MemoryFormat& format = *form.format;
  memory.format = &format;
  memory.first_node = 1;
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const Mesh& mesh = scene.objects[k];
    const Tree& tree = trees[k];
    const std::uint32_t first_matrix = memory.end_column() / apart;
    const auto matrix_of = matrix_numbers(scene, mesh, first_matrix, form.triangles);
    const glm::dmat4 to_space = form.boxes_are_cubes ? box_to_cube(tree.box) : glm::dmat4(1.0);
    const glm::dmat4 from_space = glm::inverse(to_space);
    const std::uint32_t base = add_tree(memory, tree, matrix_of, &mesh, to_space);
    const std::uint32_t outside = form.boxes_are_cubes ? tree.root : tree.clipped_root;
    objects.push_back({base + tree.root, base + outside, first_matrix, tree.box, to_space});
    check_limits(scene, form, memory);
    for (std::size_t i = 0; i < mesh.primitives(); ++i) {
      const bool three = stored_in_three(mesh, i, form.triangles);
      const UnitMatrix unit = unit_matrix(form, mesh, i, from_space, three);
      const Material& material = material_of(scene, mesh, i);
      const bool mirror = is_mirror(scene, mesh, i);
      const std::uint32_t colour = colour_bits(material.diffuse);
      const std::uint32_t part = mirror ? mirror_part(material) : 0;
      memory.columns.resize(matrix_of[i] * apart);
      if (three) {
        memory.add(to_stored_columns(format, unit, colour, part));
      } else {
        memory.add(to_columns(format, unit, colour, part));
      }
      if (mirror) {
        const glm::dmat4 reflection(reflection_matrix(mesh.corners(i)));
        memory.add(to_columns(glm::dmat4x3(to_space * reflection * from_space), 0));
      }
    }
    memory.columns.resize(matrix_of.back() * apart);
  }
}

TreeSize ObjectImage::room_left() const {
  const std::size_t reach = std::size_t{1} << form.address_bits;
  const auto left = [reach](std::size_t used) { return reach - std::min(used, reach); };
  return {left(memory.end_node()), left(memory.end_entry())};
}

std::vector<Aabb> ObjectImage::boxes() const {
  std::vector<Aabb> boxes;
  boxes.reserve(objects.size());
  for (const Object& object : objects) boxes.push_back(object.box);
  return boxes;
}

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
  if (objects.form.levels == 1) {
    start_node = root_of_all(scene, objects, camera);
  } else {
    start_node = add_instances(memory, scene, objects, instances, camera);
  }
  check_limits(scene, objects.form, memory);
  check_matrices(scene, objects.form, memory.end_matrix() + 1 + scene.lights.size());

  const glm::dmat4x3 from_pixels = dynrt::host::camera_matrix(camera, width, height);
  if (const auto element = out_of_range(format, from_pixels)) {
    refuse(messages::kCameraRange, *element, largest, largest);
  }
  camera_matrix = memory.end_matrix();
  memory.add(to_columns(from_pixels, 0));
  light_matrix = memory.end_matrix();
  for (const PointLight& light : scene.lights) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!format.holds(light.position[axis])) {
        refuse(messages::kLightRange, light.name, static_cast<char>('x' + axis),
               light.position[axis], largest, largest);
      }
    }
    memory.add(light_columns(light));
  }
}

std::uint32_t colour_bits(const glm::dvec3& colour) {
  std::uint32_t bits = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double level = std::clamp(colour[channel], 0.0, 1.0) * 255.0;
    bits |= static_cast<std::uint32_t>(std::lround(level)) << (8 * channel);
  }
  return bits;
}

bool has_mirrors(const Scene& scene) {
  for (const Mesh& object : scene.objects) {
    for (std::size_t i = 0; i < object.primitives(); ++i) {
      if (is_mirror(scene, object, i)) return true;
    }
  }
  return false;
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
