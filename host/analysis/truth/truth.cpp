// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/truth.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <glm/matrix.hpp>

#include "host/analysis/truth/candidates.h"
#include "host/analysis/truth/exact.h"
#include "host/memory/triangle_matrix.h"

namespace dynrt::host {

namespace {

constexpr std::size_t kFewPrimitives = 64;
constexpr std::size_t kRaysPerTask = 256;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// An object where an instance has put it.
struct Placed {
  const Mesh* mesh = nullptr;
  glm::dmat4 to_object{1.0};
  std::vector<glm::dvec3> vertices;                   ///< of the triangles, in the world
  std::vector<std::array<glm::dvec3, 3>> rectangles;  ///< as Mesh::corners, in the world
  std::vector<UnitMatrix> ellipsoids;                 ///< from the world to the unit sphere
};

glm::dvec3 placed(const glm::dmat4& transform, const glm::dvec3& point) {
  return glm::dvec3(transform * glm::dvec4(point, 1.0));
}

Placed place(const Mesh& mesh, const glm::dmat4& transform) {
  Placed out;
  out.mesh = &mesh;
  out.to_object = glm::inverse(transform);
  out.vertices.reserve(mesh.vertices.size());
  for (const glm::dvec3& v : mesh.vertices) out.vertices.push_back(placed(transform, v));
  for (std::size_t i = 0; i < mesh.rectangles.size(); ++i) {
    std::array<glm::dvec3, 3> corners = mesh.corners(mesh.triangles.size() + i);
    for (glm::dvec3& corner : corners) corner = placed(transform, corner);
    out.rectangles.push_back(corners);
  }
  for (const Ellipsoid& ellipsoid : mesh.ellipsoids) {
    UnitMatrix unit = ellipsoid_matrix(ellipsoid);
    unit.matrix = unit.matrix * out.to_object;
    out.ellipsoids.push_back(unit);
  }
  return out;
}

/// The interval of a ray within an ellipsoid, and the core's choice (units/intersection.h).
struct SphereIntersection {
  double first, second;  ///< NaN if the ray passes by
  double u, v;
  double cosine;  ///< at the second; minus this at the first
};

SphereIntersection intersect_sphere(const UnitMatrix& unit, const TruthRay& ray) {
  const glm::dvec3 o = unit.matrix * glm::dvec4(ray.origin, 1.0);
  const glm::dvec3 d = unit.matrix * glm::dvec4(ray.direction, 0.0);
  const auto [first, second] = sphere_hits(o, d);
  const glm::dvec3 nearest = o + 0.5 * (first + second) * d;
  const double root = 0.5 * (second - first) * glm::dot(d, d);
  return {first, second, nearest.x, nearest.y, unit.cosine_factor * root};
}

/// In the world, to the nearest edge's line: positive within.
double distance_to_edge(const FlatShape& shape, const PlaneValues& values) {
  const auto& [a, b, c] = shape.corners;
  const double area = glm::length(glm::cross(a - c, b - c));
  const double u = area / glm::length(b - c);
  const double v = area / glm::length(a - c);
  if (shape.rectangle) {
    return std::min(std::min(values.u, 1 - values.u) * u, std::min(values.v, 1 - values.v) * v);
  }
  const double w = area / glm::length(a - b);
  return std::min({values.u * u, values.v * v, (1 - values.u - values.v) * w});
}

double least_part(const FlatShape& shape, const PlaneValues& values) {
  return shape.rectangle ? std::min({values.u, values.v, 1 - values.u, 1 - values.v})
                         : std::min({values.u, values.v, 1 - values.u - values.v});
}

Line line_of(const TruthRay& ray) { return {ray.origin, ray.direction}; }

}  // namespace

struct Truth::State {
  const Scene* scene = nullptr;
  std::vector<Placed> instances;
  std::unique_ptr<CandidateTree> tree;
  mutable std::atomic<std::uint64_t> rays = 0;
  mutable std::atomic<std::uint64_t> primitives = 0;
  mutable std::atomic<std::uint64_t> exact = 0;

  FlatShape shape(PrimitiveId id) const {
    const Placed& instance = instances[id.instance];
    const Mesh& mesh = *instance.mesh;
    if (mesh.is_rectangle(id.primitive)) {
      return {instance.rectangles[id.primitive - mesh.triangles.size()], true};
    }
    const glm::uvec3& t = mesh.triangles[id.primitive];
    return {{instance.vertices[t.x], instance.vertices[t.y], instance.vertices[t.z]}, false};
  }
  bool is_ellipsoid(PrimitiveId id) const {
    return instances[id.instance].mesh->is_ellipsoid(id.primitive);
  }
  const UnitMatrix& ellipsoid(PrimitiveId id) const {
    const Placed& instance = instances[id.instance];
    const std::size_t before = instance.mesh->triangles.size() + instance.rectangles.size();
    return instance.ellipsoids[id.primitive - before];
  }
  std::vector<std::vector<CandidateBox>> boxes() const;
  double cosine(PrimitiveId id, const glm::dvec3& direction) const;
  class Search;
};

/// Every primitive's box.
std::vector<std::vector<CandidateBox>> Truth::State::boxes() const {
  std::vector<std::vector<CandidateBox>> all(instances.size());
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    const Mesh& mesh = *instances[i].mesh;
    for (std::uint32_t k = 0; k < mesh.primitives(); ++k) {
      CandidateBox box{glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
      const auto add = [&](const glm::dvec3& point) {
        box.low = glm::min(box.low, point);
        box.high = glm::max(box.high, point);
      };
      if (mesh.is_ellipsoid(k)) {
        const Ellipsoid in_world{scene->instances[i].transform * mesh.ellipsoid(k).from_unit};
        const glm::dvec3 centre(in_world.from_unit[3]);
        // Decided in doubles, so a ray that doubles say touches it must find it.
        const glm::dvec3 extent = in_world.extent() * (1 + 1e-9);
        add(centre - extent);
        add(centre + extent);
      } else {
        const FlatShape flat = shape({i, k});
        for (const glm::dvec3& corner : flat.corners) add(corner);
        const auto& [a, b, c] = flat.corners;
        if (flat.rectangle) add(a + (b - c));
      }
      all[i].push_back(box);
    }
  }
  return all;
}

double Truth::State::cosine(PrimitiveId id, const glm::dvec3& direction) const {
  const Placed& instance = instances[id.instance];
  const auto [a, b, c] = instance.mesh->corners(id.primitive);
  const glm::dvec3 normal = glm::normalize(glm::cross(a - c, b - c));
  return glm::dot(normal, glm::dvec3(instance.to_object * glm::dvec4(direction, 0.0)));
}

/// One ray on its way: keeps all that are hit at the nearest t.
class Truth::State::Search : public CandidateVisitor {
 public:
  Search(const State& state, const TruthRay& ray, bool any)
      : state_(state), ray_(ray), line_(line_of(ray)), any_(any) {}

  ~Search() override {
    state_.rays.fetch_add(1, std::memory_order_relaxed);
    state_.primitives.fetch_add(primitives_, std::memory_order_relaxed);
    state_.exact.fetch_add(exact_, std::memory_order_relaxed);
  }

  void run() {
    if (state_.tree && state_.tree->visit(ray_, *this)) return;
    for (std::uint32_t i = 0; i < state_.instances.size(); ++i) {
      const std::size_t count = state_.instances[i].mesh->primitives();
      for (std::uint32_t k = 0; k < count; ++k) {
        if (visit({i, k}) < ray_.from) return;
      }
    }
  }

  double visit(PrimitiveId id) override {
    if (id != ray_.own) {
      ++primitives_;
      state_.is_ellipsoid(id) ? try_ellipsoid(id) : try_flat(id);
    }
    if (nearest_.empty()) return ray_.to;
    return any_ ? -kInfinity : nearest_.front().t_high;
  }

  bool found() const { return !nearest_.empty(); }

  std::optional<TruthHit> hit() {
    if (nearest_.empty()) return std::nullopt;
    std::ranges::sort(nearest_, {}, &Candidate::id);
    const Candidate& best = nearest_.front();
    TruthHit out;
    out.id = best.id;
    out.place = best.place;
    for (std::size_t i = 1; i < nearest_.size(); ++i) out.ties.push_back(nearest_[i].id);
    if (best.ellipsoid) {
      const SphereIntersection intersection = intersect_sphere(state_.ellipsoid(best.id), ray_);
      out.t = best.t_low;
      out.u = intersection.u;
      out.v = intersection.v;
      out.cosine = out.t == intersection.first ? -intersection.cosine : intersection.cosine;
      out.margin = out.edge_distance = kInfinity;
      return out;
    }
    const FlatShape shape = state_.shape(best.id);
    const PlaneValues values = plane_values(line_, shape).value();
    out.t = values.t;
    out.u = values.u;
    out.v = values.v;
    out.cosine = state_.cosine(best.id, ray_.direction);
    if (best.place == HitPlace::kInside) {
      out.margin = std::max(0.0, least_part(shape, values));
      out.edge_distance = std::max(0.0, distance_to_edge(shape, values));
    }
    return out;
  }

 private:
  struct Candidate {
    PrimitiveId id;
    HitPlace place = HitPlace::kInside;
    bool ellipsoid = false;
    double t_low = 0, t_high = 0;
  };

  void try_flat(PrimitiveId id) {
    const FlatShape shape = state_.shape(id);
    const Crossing crossing = cross(line_, shape, exact_);
    if (!crossing.hit) return;
    const Candidate now{id, crossing.place, false, crossing.t_low, crossing.t_high};
    if (compared_with(now, ray_.from) <= 0) return;
    if (ray_.to < kInfinity && compared_with(now, ray_.to) >= 0) return;
    take(now);
  }
  void try_ellipsoid(PrimitiveId id) {
    const SphereIntersection intersection = intersect_sphere(state_.ellipsoid(id), ray_);
    for (const double t : {intersection.first, intersection.second}) {
      if (!(t > ray_.from && t < ray_.to)) continue;
      take({id, HitPlace::kInside, true, t, t});
      return;
    }
  }

  int compared_with(const Candidate& a, double t) {
    if (a.t_low > t) return 1;
    if (a.t_high < t) return -1;
    ++exact_;
    return compare_t(line_, state_.shape(a.id), t);
  }
  int compared(const Candidate& a, const Candidate& b) {
    if (a.t_high < b.t_low) return -1;
    if (a.t_low > b.t_high) return 1;
    if (a.ellipsoid && b.ellipsoid) return 0;
    if (b.ellipsoid) return compared_with(a, b.t_low);
    if (a.ellipsoid) return -compared_with(b, a.t_low);
    ++exact_;
    return compare_t(line_, state_.shape(a.id), state_.shape(b.id));
  }
  void take(const Candidate& now) {
    const int order = nearest_.empty() ? -1 : compared(now, nearest_.front());
    if (order > 0) return;
    if (order < 0) nearest_.clear();
    if (std::ranges::find(nearest_, now.id, &Candidate::id) == nearest_.end()) {
      nearest_.push_back(now);
    }
  }

  const State& state_;
  const TruthRay& ray_;
  const Line line_;
  const bool any_;
  std::vector<Candidate> nearest_;  ///< all at the same t
  std::uint64_t primitives_ = 0;
  std::uint64_t exact_ = 0;
};

bool TruthHit::tied_with(PrimitiveId other) const {
  return other == id || std::ranges::binary_search(ties, other);
}

Truth::Truth(const Scene& scene, TruthSearch search) : state_(std::make_unique<State>()) {
  state_->scene = &scene;
  std::size_t primitives = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.objects.at(instance.object);
    state_->instances.push_back(place(mesh, instance.transform));
    primitives += mesh.primitives();
  }
  const bool few = primitives <= kFewPrimitives;
  if (search == TruthSearch::kTree || (search == TruthSearch::kAutomatic && !few)) {
    state_->tree = std::make_unique<CandidateTree>(state_->boxes());
  }
}

Truth::~Truth() = default;

std::optional<TruthHit> Truth::nearest(const TruthRay& ray) const {
  State::Search search(*state_, ray, false);
  search.run();
  return search.hit();
}

std::vector<std::optional<TruthHit>> Truth::nearest(std::span<const TruthRay> rays) const {
  std::vector<std::optional<TruthHit>> hits(rays.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), kRaysPerTask),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        hits[i] = nearest(rays[i]);
                      }
                    });
  return hits;
}

bool Truth::any(const TruthRay& ray) const {
  State::Search search(*state_, ray, true);
  search.run();
  return search.found();
}

std::optional<PlaneIntersection> Truth::intersect(const TruthRay& ray, PrimitiveId id) const {
  PlaneIntersection out;
  if (state_->is_ellipsoid(id)) {
    const SphereIntersection intersection = intersect_sphere(state_->ellipsoid(id), ray);
    if (std::isnan(intersection.first)) return std::nullopt;
    const bool enters = intersection.first > 0;
    out.t = enters ? intersection.first : intersection.second;
    out.u = intersection.u;
    out.v = intersection.v;
    out.cosine = enters ? -intersection.cosine : intersection.cosine;
    out.hit = out.t > 0;
    out.edge_distance = kInfinity;
    return out;
  }
  const FlatShape shape = state_->shape(id);
  const Line line = line_of(ray);
  const auto values = plane_values(line, shape);
  if (!values) return std::nullopt;
  out.t = values->t;
  out.u = values->u;
  out.v = values->v;
  out.cosine = state_->cosine(id, ray.direction);
  std::uint64_t exact = 0;
  out.hit = out.t > 0 && cross(line, shape, exact).hit;
  out.edge_distance = distance_to_edge(shape, *values);
  return out;
}

std::array<glm::dvec3, 3> Truth::corners(PrimitiveId id) const { return state_->shape(id).corners; }

bool Truth::touch(PrimitiveId a, PrimitiveId b) const {
  if (state_->is_ellipsoid(a) || state_->is_ellipsoid(b)) return false;
  const auto of_b = corners(b);
  return std::ranges::any_of(corners(a), [&](const glm::dvec3& corner) {
    return std::ranges::find(of_b, corner) != of_b.end();
  });
}

const Scene& Truth::scene() const { return *state_->scene; }

TruthCounts Truth::counts() const { return {state_->rays, state_->primitives, state_->exact}; }

}  // namespace dynrt::host
