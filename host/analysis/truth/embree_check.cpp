// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/embree_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "host/analysis/truth/embree.h"

namespace dynrt::host {

namespace {

/// The error of Embree's floats if coordinates and distances have magnitude 1: vertices, origin and
/// direction by half a step of 2^-23 each, and sums and products of them by a few.
constexpr double kFloatError = 0x1p-20;

class EmbreeCaster {
 public:
  explicit EmbreeCaster(const Truth& truth)
      : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_.get())) {
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    const Scene& scene = truth.scene();
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      attach(scene.objects[scene.instances[i].object], scene.instances[i].transform);
    }
    rtcCommitScene(scene_.get());
  }

  std::optional<PrimitiveId> nearest(const TruthRay& ray) const {
    RTCRayHit hit{};
    hit.ray.org_x = static_cast<float>(ray.origin.x);
    hit.ray.org_y = static_cast<float>(ray.origin.y);
    hit.ray.org_z = static_cast<float>(ray.origin.z);
    hit.ray.dir_x = static_cast<float>(ray.direction.x);
    hit.ray.dir_y = static_cast<float>(ray.direction.y);
    hit.ray.dir_z = static_cast<float>(ray.direction.z);
    hit.ray.tfar = std::numeric_limits<float>::infinity();
    hit.ray.mask = ~0u;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    EmbreeContext context;
    intersect(scene_, context, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return PrimitiveId{hit.hit.geomID, hit.hit.primID};
  }

 private:
  void attach(const Mesh& mesh, const glm::dmat4& transform) {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const glm::dvec3 v(transform * glm::dvec4(mesh.vertices[i], 1.0));
      for (int k = 0; k < 3; ++k)
        vertices[3 * i + static_cast<unsigned>(k)] = static_cast<float>(v[k]);
    }
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) corners[3 * i + static_cast<unsigned>(k)] = mesh.triangles[i][k];
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
  }

  EmbreeDevice device_;
  EmbreeScene scene_;
};

double largest(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The primitives whose hit is uncertain, as the ray has the error of floats.
class Doubt {
 public:
  Doubt(const Truth& truth, const TruthRay& ray) : truth_(truth), ray_(ray) {}

  bool is_hit(PrimitiveId id) const {
    const auto intersection = truth_.intersect(ray_, id);
    return intersection && intersection->hit;
  }
  /// Whether this is hit.
  bool about_edge(PrimitiveId id) const {
    const auto intersection = truth_.intersect(ray_, id);
    if (!intersection) return true;  // within the plane, hence at no height above any edge
    const double error = error_at(id, intersection->t);
    // Aslant, a ray that is moved aside moves farther in the plane.
    return std::abs(intersection->edge_distance) * slope(id) <= error ||
           std::abs(intersection->t) * glm::length(ray_.direction) * slope(id) <= error;
  }
  /// Which of the two lies before the other.
  bool about_distance(PrimitiveId a, PrimitiveId b) const {
    const auto first = truth_.intersect(ray_, a);
    const auto second = truth_.intersect(ray_, b);
    if (!first || !second) return true;
    const double apart = std::abs(first->t - second->t) * glm::length(ray_.direction);
    return apart <= error_at(a, first->t) / slope(a) + error_at(b, second->t) / slope(b);
  }

 private:
  /// In the world, across the ray.
  double error_at(PrimitiveId id, double t) const {
    double size = largest(ray_.origin) + std::abs(t) * largest(ray_.direction);
    for (const glm::dvec3& corner : truth_.corners(id)) size = std::max(size, largest(corner));
    return kFloatError * size;
  }
  /// The sine of the angle between ray and plane.
  double slope(PrimitiveId id) const {
    const auto [a, b, c] = truth_.corners(id);
    const glm::dvec3 normal = glm::normalize(glm::cross(a - c, b - c));
    return std::abs(glm::dot(normal, glm::normalize(ray_.direction)));
  }

  const Truth& truth_;
  const TruthRay& ray_;
};

}  // namespace

EmbreeComparison compare_with_embree(const Truth& truth, std::span<const TruthRay> rays,
                                     std::span<const std::optional<TruthHit>> hits) {
  const EmbreeCaster caster(truth);
  EmbreeComparison out;
  out.rays = rays.size();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto found = caster.nearest(rays[i]);
    const auto& hit = hits[i];
    out.hits += hit.has_value();
    if (hit.has_value() == found.has_value() && (!hit || hit->id == *found)) {
      ++out.same;
      continue;
    }
    if (hit && found && hit->tied_with(*found)) {
      ++out.ties;
      continue;
    }
    const Doubt doubt(truth, rays[i]);
    const bool is_hit = found && doubt.is_hit(*found);
    // Either Embree found a primitive that is not hit, or it missed one that is hit and found none
    // or one behind it.
    const std::optional<PrimitiveId> missed = hit ? std::optional(hit->id) : std::nullopt;
    const auto wrong = found && !is_hit ? found : missed;
    if (hit && is_hit && doubt.about_distance(hit->id, *found)) {
      ++out.near_in_distance;
    } else if (wrong && doubt.about_edge(*wrong)) {
      ++out.near_an_edge;
    } else {
      ++out.unexplained;
      if (!out.first_unexplained) out.first_unexplained = i;
    }
  }
  return out;
}

std::string EmbreeComparison::text() const {
  return fmt::format(
      "{} rays, {} hits: Embree names the same primitive {} times, one tied with it {}, one that "
      "floats cannot tell from it by distance {}, one whose edge is too near for floats {}; not "
      "explained {}",
      rays, hits, same, ties, near_in_distance, near_an_edge, unexplained);
}

}  // namespace dynrt::host
