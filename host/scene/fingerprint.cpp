// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/fingerprint.h"

#include <bit>
#include <concepts>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>

namespace dynrt::host {

namespace {

// FNV-1a, taking 64 bits at a time; its last step lets the upper bits count in the lower ones.
class Hash {
 public:
  void add(std::unsigned_integral auto number) {
    state_ = (state_ ^ number) * 0x100000001b3u;
    state_ ^= state_ >> 32;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const glm::dvec3& v) { add_all(glm::value_ptr(v), 3); }
  void add(const glm::dquat& q) { add_all(glm::value_ptr(q), 4); }
  void add(const glm::dmat4& m) { add_all(glm::value_ptr(m), 16); }
  void add(const glm::uvec3& v) { add_all(glm::value_ptr(v), 3); }

  void add(const Material& material) {
    add(material.diffuse);
    add(material.mirror);
  }
  void add(const Mesh& mesh) {
    add(mesh.vertices);
    add(mesh.triangles);
    add(mesh.material);
    add(mesh.rectangles);
    add(mesh.ellipsoids);
  }
  void add(const Rectangle& rectangle) {
    for (const glm::dvec3& v : {rectangle.corner, rectangle.across, rectangle.along}) add(v);
    add(rectangle.material);
  }
  void add(const Ellipsoid& ellipsoid) {
    add(ellipsoid.from_unit);
    add(ellipsoid.material);
  }
  void add(const Instance& instance) {
    add(instance.object);
    add(instance.transform);
    add(instance.motion);
  }
  template <typename T>
  void add(const Keyframe<T>& key) {
    add(key.time);
    add(key.value);
  }
  void add(const MotionNode& node) {
    add(node.parent);
    add(node.transform);
    add(node.position);
    add(node.rotation);
    add(node.scale);
    add(std::uint32_t{node.repeats});
  }
  void add(const Camera& camera) {
    for (const glm::dvec3& v : {camera.position, camera.right, camera.up, camera.forward}) add(v);
  }
  void add(const PathKey& key) {
    add(key.time);
    add(key.position);
    add(key.look_at);
  }
  void add(const PointLight& light) {
    add(light.position);
    add(light.colour);
  }
  template <typename T>
  void add(const std::vector<T>& list) {
    add(list.size());
    for (const T& item : list) add(item);
  }
  template <typename T>
  void add(const std::optional<T>& item) {
    add(std::uint32_t{item.has_value()});
    if (item) add(*item);
  }

  std::uint64_t value() const { return state_; }

 private:
  template <typename T>
  void add_all(const T* numbers, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add(numbers[i]);
  }

  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t fingerprint(const Scene& scene) {
  Hash hash;
  hash.add(scene.materials);
  hash.add(scene.objects);
  hash.add(scene.instances);
  hash.add(scene.camera);
  hash.add(scene.lights);
  hash.add(scene.motion);
  hash.add(scene.camera_motion);
  hash.add(scene.path);
  hash.add(scene.path_up);
  return hash.value();
}

}  // namespace dynrt::host
