// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Finds the primitives that a ray really hits, independently of the core, its trees and its
// numbers. Every measure of error compares with it.
//
// A scene is taken to the world once: every vertex of every instance is transform * vertex, rounded
// to doubles, so that triangles which share a vertex still share it. From there on nothing is
// rounded that decides: the signs of the edge functions, the sign of t, whether t lies in the ray's
// interval and which of two t is smaller are the signs of polynomials in the doubles of ray and
// vertices, found by interval arithmetic and, where an interval holds zero, by exact arithmetic
// (exact.h). t, u and v are good to 1e-12; they and the cosine are the only rounded things.
//
// Triangles and rectangles are closed: edges and vertices belong to them, so that a ray through an
// edge hits all triangles there; the result lists them. A ray within a triangle's plane does not
// hit it. A rectangle is the parallelogram of three of its corners in the world. Ellipsoids are
// computed in doubles, decisions too.
//
// Units: lengths as in the scene, t in lengths of the ray's direction.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "host/scene/primitive_id.h"
#include "host/scene/scene.h"

namespace dynrt::host {

/// Hits lie at from < t < to.
struct TruthRay {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< of any length but zero
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
  std::optional<PrimitiveId> own{};  ///< not seen: where a light or reflection ray belongs
};

/// Where on a primitive a hit lies, decided exactly (of an ellipsoid always inside).
enum class HitPlace : std::uint8_t { kInside, kEdge, kVertex };

struct TruthHit {
  PrimitiveId id;  ///< of all at the nearest t the one with the lowest numbers
  double t = 0;
  /// Of a triangle (a, b, c) the weights of a and b; of a rectangle the parts of across and along;
  /// of an ellipsoid x and y of the point nearest to its centre, in unit space (as the core's).
  double u = 0;
  double v = 0;
  /// Direction times unit normal, both in the object's space: it is this that the core shades with.
  double cosine = 0;
  HitPlace place = HitPlace::kInside;
  /// To the nearest edge: the smallest of u, v, 1 - u - v (rectangle: of u, v, 1 - u, 1 - v), 0 to
  /// 1/3 (1/2); and the same as a length in the world. Infinite on ellipsoids.
  double margin = 0;
  double edge_distance = 0;
  /// All others that the ray hits at exactly the same t, in order: neighbours at an edge,
  /// coincident ones.
  std::vector<PrimitiveId> ties;

  bool tied_with(PrimitiveId other) const;  ///< or the hit itself
};

/// The point where a ray meets a primitive's plane, inside or outside the primitive. For checking
/// the hits of others.
struct PlaneIntersection {
  double t = 0;
  double u = 0;
  double v = 0;
  double cosine = 0;
  bool hit = false;  ///< as nearest() has it, by this primitive alone
  /// In the world, to the nearest edge: positive within the primitive, negative outside.
  double edge_distance = 0;
};

/// The search for the candidates of a ray. All give the same result (truth_test).
enum class TruthSearch : std::uint8_t {
  kAutomatic,   ///< brute force up to a few dozen primitives
  kBruteForce,  ///< every primitive
  kTree,        ///< Embree's traversal over boxes that are grown by more than its floats err
};

/// The numbers of decisions in each arithmetic.
struct TruthCounts {
  std::uint64_t rays = 0;
  std::uint64_t primitives = 0;  ///< tested
  std::uint64_t exact = 0;       ///< decisions that intervals of doubles left open
};

/// Threads may share one.
class Truth {
 public:
  /// The scene must outlive this and must not change.
  explicit Truth(const Scene& scene, TruthSearch search = TruthSearch::kAutomatic);
  ~Truth();
  Truth(const Truth&) = delete;
  Truth& operator=(const Truth&) = delete;

  std::optional<TruthHit> nearest(const TruthRay& ray) const;
  /// Of many rays, on all processors.
  std::vector<std::optional<TruthHit>> nearest(std::span<const TruthRay> rays) const;
  /// Tells whether the ray hits anything.
  bool any(const TruthRay& ray) const;
  /// Nothing where the ray is parallel to the plane, or passes by the ellipsoid. The ray's interval
  /// and `own` are not looked at, but the sign of t is for `hit`.
  std::optional<PlaneIntersection> intersect(const TruthRay& ray, PrimitiveId id) const;

  /// Corners in the world: of a triangle, or of a rectangle those of Mesh::corners.
  std::array<glm::dvec3, 3> corners(PrimitiveId id) const;
  /// Whether two triangles have a vertex in common, by its place in the world.
  bool touch(PrimitiveId a, PrimitiveId b) const;

  const Scene& scene() const;
  TruthCounts counts() const;  ///< since it was made

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace dynrt::host
