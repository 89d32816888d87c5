// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/rays.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "host/layout/frame_image.h"

namespace dynrt::host {

namespace {

/// As the core finds it, where the margin is a number of steps of t's mantissa: a step is twice as
/// long from the next power of two on.
double behind(double t) {
  const int exponent = std::ilogb(t);
  const double next = std::ldexp(2.0, exponent);
  const double sum = t + std::ldexp(kSurfaceMargin, exponent);
  return sum < next ? sum : next + 2 * (sum - next);
}

}  // namespace

TruthRay primary_ray(const Camera& camera, unsigned width, unsigned height, unsigned x,
                     unsigned y) {
  const glm::dmat4x3 matrix = camera_matrix(camera, width, height);
  return {camera.position, matrix * glm::dvec4(x, y, 1.0, 0.0)};
}

TruthRay light_ray(const Scene& scene, const PointLight& light, const TruthRay& ray,
                   const TruthHit& hit) {
  TruthRay out;
  out.origin = light.position;
  out.direction = ray.origin + hit.t * ray.direction - light.position;
  out.to = 1.0 - kSurfaceMargin;
  const Mesh& mesh = scene.objects[scene.instances[hit.id.instance].object];
  if (!mesh.is_ellipsoid(hit.id.primitive)) out.own = hit.id;
  return out;
}

std::optional<TruthRay> reflection_ray(const Scene& scene, const TruthRay& ray,
                                       const TruthHit& hit) {
  const Instance& instance = scene.instances[hit.id.instance];
  const Mesh& mesh = scene.objects[instance.object];
  if (mesh.is_ellipsoid(hit.id.primitive)) return std::nullopt;
  const auto [a, b, c] = mesh.corners(hit.id.primitive);
  const glm::dvec3 normal = glm::normalize(glm::cross(a - c, b - c));
  const glm::dmat4 to_object = glm::inverse(instance.transform);
  const glm::dvec3 origin(to_object * glm::dvec4(ray.origin, 1.0));
  const glm::dvec3 direction(to_object * glm::dvec4(ray.direction, 0.0));
  const glm::dvec3 mirrored_origin = origin - 2.0 * glm::dot(normal, origin - c) * normal;
  const glm::dvec3 mirrored = direction - 2.0 * glm::dot(normal, direction) * normal;
  TruthRay out;
  out.origin = glm::dvec3(instance.transform * glm::dvec4(mirrored_origin, 1.0));
  out.direction = glm::dvec3(instance.transform * glm::dvec4(mirrored, 0.0));
  out.from = behind(hit.t);
  out.own = hit.id;
  return out;
}

}  // namespace dynrt::host
