// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/animation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/spline.hpp>

#include "host/error.h"
#include "host/scene/camera.h"
#include "host/scene/import.h"

namespace dynrt::host {

namespace {

// Between which keys a time lies, and how far along.
struct Span {
  std::size_t from = 0, to = 0;
  double part = 0.0;  // [0, 1]
};

template <typename Keys>
Span span(const Keys& keys, double time) {
  const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                      [](double t, const auto& key) { return t < key.time; });
  const auto next = static_cast<std::size_t>(after - keys.begin());
  if (next == 0) return {};
  if (next == keys.size()) return {next - 1, next - 1, 0.0};
  const double begin = keys[next - 1].time, end = keys[next].time;
  return {next - 1, next, (time - begin) / (end - begin)};
}

glm::dvec3 value(const std::vector<Keyframe<glm::dvec3>>& keys, double time) {
  const Span s = span(keys, time);
  return glm::mix(keys[s.from].value, keys[s.to].value, s.part);
}

glm::dquat value(const std::vector<Keyframe<glm::dquat>>& keys, double time) {
  const Span s = span(keys, time);
  return glm::slerp(keys[s.from].value, keys[s.to].value, s.part);
}

template <typename Keys>
double last_time(const Keys& keys) {
  return keys.empty() ? 0.0 : keys.back().time;
}

double last_time(const MotionNode& node) {
  return std::max({last_time(node.position), last_time(node.rotation), last_time(node.scale)});
}

glm::dmat4 local_at(const MotionNode& node, double time) {
  if (!node.moves()) return node.transform;
  const double period = last_time(node);
  if (node.repeats && period > 0.0) time -= period * std::floor(time / period);
  glm::dmat4 m(1.0);
  if (!node.position.empty()) m = glm::translate(m, value(node.position, time));
  if (!node.rotation.empty()) m *= glm::mat4_cast(value(node.rotation, time));
  if (!node.scale.empty()) m = glm::scale(m, value(node.scale, time));
  return m;
}

// MotionNode to world, of every node. Parents come before their children.
std::vector<glm::dmat4> nodes_at(const Scene& scene, double time) {
  std::vector<glm::dmat4> nodes;
  nodes.reserve(scene.motion.size());
  for (const MotionNode& node : scene.motion) {
    const glm::dmat4 local = local_at(node, time);
    nodes.push_back(node.parent ? nodes[*node.parent] * local : local);
  }
  return nodes;
}

// A cubic Hermite curve whose slope at a key is that from the key before to the key after.
template <typename Get>
glm::dvec3 smooth(const std::vector<PathKey>& keys, double time, Get get) {
  const Span s = span(keys, time);
  const auto slope = [&](std::size_t k) {
    const std::size_t before = k == 0 ? 0 : k - 1, after = std::min(k + 1, keys.size() - 1);
    return (get(keys[after]) - get(keys[before])) / (keys[after].time - keys[before].time);
  };
  if (s.from == s.to) return get(keys[s.from]);
  const double seconds = keys[s.to].time - keys[s.from].time;
  return glm::hermite(get(keys[s.from]), seconds * slope(s.from), get(keys[s.to]),
                      seconds * slope(s.to), s.part);
}

std::vector<glm::dmat4> transforms(const Scene& scene, const std::vector<glm::dmat4>& nodes) {
  std::vector<glm::dmat4> transforms;
  transforms.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    transforms.push_back(instance.motion ? nodes[*instance.motion] : instance.transform);
  }
  return transforms;
}

std::optional<Camera> camera(const Scene& scene, const std::vector<glm::dmat4>& nodes,
                             double time) {
  if (!scene.camera) return std::nullopt;
  try {
    const double field_of_view = field_of_view_of(*scene.camera);
    if (!scene.path.empty()) {
      const glm::dvec3 position =
          smooth(scene.path, time, [](const PathKey& key) { return key.position; });
      const glm::dvec3 target =
          smooth(scene.path, time, [](const PathKey& key) { return key.look_at; });
      return look_at(position, target, scene.path_up, field_of_view, 1.0);
    }
    if (scene.camera_motion) {
      const glm::dmat4& m = nodes[*scene.camera_motion];
      const glm::dvec3 position(m[3]);
      return look_at(position, position - glm::dvec3(m[2]), glm::dvec3(m[1]), field_of_view, 1.0);
    }
  } catch (const UserError& error) {
    refuse("{}, after {} seconds: {}", scene.name, time, error.what());
  }
  return scene.camera;
}

}  // namespace

double duration(const Scene& scene) {
  double last = last_time(scene.path);
  for (const MotionNode& node : scene.motion) last = std::max(last, last_time(node));
  return last;
}

std::vector<double> moments_of(const Scene& scene) {
  constexpr int kMoments = 64;
  std::vector<double> times{0.0};
  const auto add = [&](const auto& keys) {
    for (const auto& key : keys) times.push_back(key.time);
  };
  add(scene.path);
  for (const MotionNode& node : scene.motion) {
    add(node.position);
    add(node.rotation);
    add(node.scale);
  }
  const double last = duration(scene);
  for (int i = 1; last > 0 && i <= kMoments; ++i) times.push_back(last * i / kMoments);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::vector<glm::dmat4> transforms_at(const Scene& scene, double time) {
  return transforms(scene, nodes_at(scene, time));
}

std::optional<Camera> camera_at(const Scene& scene, double time) {
  return camera(scene, nodes_at(scene, time), time);
}

void move_to(Scene& scene, double time) {
  const std::vector<glm::dmat4> nodes = nodes_at(scene, time);
  const std::vector<glm::dmat4> placed = transforms(scene, nodes);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    Instance& instance = scene.instances[i];
    if (!instance.motion) continue;
    instance.transform = placed[i];
    require_inverse(instance, fmt::format("{}, after {} seconds", scene.name, time));
  }
  scene.camera = camera(scene, nodes, time);
}

}  // namespace dynrt::host
