// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The tracer through the trees finds what brute force finds.
#include "host/analysis/counts/counts.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "host/memory/triangle_matrix.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

constexpr unsigned kSide = 32;

/// The closest hit of every pixel, without trees or packets.
std::vector<TracedHit> brute_force(const Scene& scene, const Camera& camera) {
  std::vector<TracedHit> hits(std::size_t{kSide} * kSide);
  for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
    const Instance& instance = scene.instances[n];
    const Mesh& mesh = scene.objects[instance.object];
    const glm::dmat4 to_object = glm::inverse(instance.transform);
    const glm::dvec3 origin(to_object * glm::dvec4(camera.position, 1));
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      const glm::dvec3& c = mesh.vertices[t.z];
      const glm::dvec3 a = mesh.vertices[t.x] - c;
      const glm::dvec3 b = mesh.vertices[t.y] - c;
      for (unsigned y = 0; y < kSide; ++y) {
        for (unsigned x = 0; x < kSide; ++x) {
          const glm::dvec3 d(to_object *
                             glm::dvec4(((x + 0.5) / kSide - 0.5) * camera.right +
                                            (0.5 - (y + 0.5) / kSide) * camera.up + camera.forward,
                                        0));
          const glm::dvec3 p = glm::cross(d, b);
          const double det = glm::dot(a, p);
          const double u = glm::dot(origin - c, p) / det;
          const glm::dvec3 q = glm::cross(origin - c, a);
          const double v = glm::dot(d, q) / det;
          const double distance = glm::dot(b, q) / det;
          TracedHit& hit = hits[y * kSide + x];
          if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && (!hit.hit || distance < hit.t)) {
            hit = {true, distance, u, v, n, i};
          }
        }
      }
    }
  }
  return hits;
}

/// Compares all pixels; returns how many were hit.
int expect_same_hits(const Scene& scene, const Camera& camera) {
  const SceneTrees trees = build_scene_trees(scene);
  const std::vector<TracedHit> expected = brute_force(scene, camera);
  int hits = 0;
  for (const Clipping clipping : {Clipping::kFromOutside, Clipping::kAlways}) {
    TraceOptions options;
    options.scene_clipping = options.object_clipping = clipping;
    const TracedFrame frame = trace_frame(scene, trees, camera, kSide, kSide, options);
    EXPECT_EQ(frame.work.packets, kSide * kSide / 4);
    EXPECT_EQ(frame.work.dropped_pushes, 0u);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const TracedHit& got = frame.hits[i];
      EXPECT_EQ(got.hit, expected[i].hit) << "pixel " << i;
      if (!got.hit || !expected[i].hit) continue;
      ++hits;
      EXPECT_NEAR(got.t, expected[i].t, 1e-9 * expected[i].t) << "pixel " << i;
      if (std::abs(got.t - expected[i].t) == 0) continue;
      EXPECT_TRUE(got.triangle == expected[i].triangle || got.t <= expected[i].t * (1 + 1e-9));
    }
  }
  return hits;
}

TEST(Counts, HitsAreThoseOfBruteForce) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Scene scene = testing::scene_of(testing::soup(seed, 1000, 0.15));
    EXPECT_GT(expect_same_hits(scene, testing::camera_at({0.05, 0.02, 3.1}, {0.1, 0, -1})), 100);
    EXPECT_GT(expect_same_hits(scene, testing::camera_at({0.05, 0.02, 0.1}, {0.3, 0.2, 1})), 100);
  }
}

TEST(Counts, RoomsAreTight) {
  const Scene scene = testing::scene_of(testing::room(1, 8, 8));
  EXPECT_EQ(expect_same_hits(scene, testing::camera_at({2.013, 1.71, 4.02}, {-0.1, -0.2, -1})),
            2 * static_cast<int>(kSide * kSide));
}

TEST(Counts, ACameraOnASplitLosesNoRays) {
  Mesh floor;
  for (int z = -4; z < 4; ++z) {
    for (int x = -4; x < 4; ++x) {
      testing::add_quad(floor, {x, 0.1 * ((x * x + z) % 3), z}, {0, 0, 1}, {1, 0.01, 0});
    }
  }
  const Scene scene = testing::scene_of(floor);
  EXPECT_GT(expect_same_hits(scene, testing::camera_at({0, 3, 0}, {0.001, -1, 0.002})), 500);
}

/// Distance along the ray to the closest rectangle or ellipsoid; infinity where there is none.
double closest_primitive(const Mesh& mesh, const glm::dvec3& origin, const glm::dvec3& d) {
  double best = std::numeric_limits<double>::infinity();
  for (const Rectangle& r : mesh.rectangles) {
    const glm::dvec3 uvt = glm::inverse(glm::dmat3(r.across, r.along, -d)) * (origin - r.corner);
    if (uvt.x >= 0 && uvt.x <= 1 && uvt.y >= 0 && uvt.y <= 1 && uvt.z > 0) {
      best = std::min(best, uvt.z);
    }
  }
  for (const Ellipsoid& e : mesh.ellipsoids) {
    // |o + t d|^2 = 1 in the space of the unit sphere, as a quadratic equation.
    const glm::dmat4 inverse = glm::inverse(e.from_unit);
    const glm::dvec3 o(inverse * glm::dvec4(origin, 1)), l(inverse * glm::dvec4(d, 0));
    const double a = glm::dot(l, l), b = 2 * glm::dot(o, l), c = glm::dot(o, o) - 1;
    const double discriminant = b * b - 4 * a * c;
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-b + sign * std::sqrt(discriminant)) / (2 * a);
      if (t > 0) best = std::min(best, t);
    }
  }
  return best;
}

TEST(Counts, RectanglesAndEllipsoidsAreHit) {
  Mesh mesh;
  mesh.name = "primitives";
  for (int i = 0; i < 6; ++i) {
    const double x = 0.7 * i - 1.8;
    mesh.rectangles.push_back({{x, -0.3, -0.2 * i}, {0.5, 0.1, 0.2}, {0.2, 0.8, 0}});
    glm::dmat4 from_unit = glm::translate(glm::dmat4(1), glm::dvec3(x, 0.6, 0.1 * i - 0.3));
    from_unit[1][0] = 0.3;
    mesh.ellipsoids.push_back({glm::scale(from_unit, glm::dvec3(0.3, 0.2 + 0.05 * i, 0.25))});
  }
  const Scene scene = testing::scene_of(mesh);
  const Camera camera = testing::camera_at({0.1, 0.2, 3.5}, {0.02, 0.01, -1});
  const TracedFrame frame = trace_frame(scene, build_scene_trees(scene), camera, kSide, kSide);
  int hits[2] = {};
  for (unsigned y = 0; y < kSide; ++y) {
    for (unsigned x = 0; x < kSide; ++x) {
      const glm::dvec3 d = ((x + 0.5) / kSide - 0.5) * camera.right +
                           (0.5 - (y + 0.5) / kSide) * camera.up + camera.forward;
      const double expected = closest_primitive(mesh, camera.position, d);
      const TracedHit& got = frame.hits[y * kSide + x];
      ASSERT_EQ(got.hit, std::isfinite(expected)) << x << ' ' << y;
      if (!got.hit) continue;
      ASSERT_NEAR(got.t, expected, 1e-9) << x << ' ' << y;
      ++hits[mesh.is_ellipsoid(got.triangle)];
    }
  }
  EXPECT_GT(hits[0], 20);
  EXPECT_GT(hits[1], 20);
}

TEST(Counts, InstancesAreHitThroughBothLevels) {
  Scene scene = testing::scene_of(testing::soup(5, 300, 0.3));
  scene.objects.push_back({});
  testing::add_sphere(scene.objects.back(), {0, 0, 0}, 1, 8);
  scene.instances.clear();
  std::mt19937 random(6);
  std::uniform_real_distribution<double> at(-4, 4), size(-1.5, 1.5);
  for (int i = 0; i < 40; ++i) {
    glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(at(random), at(random), at(random)));
    m = glm::rotate(m, at(random), glm::dvec3(0.3, 1, 0.2));
    m = glm::scale(m, glm::dvec3(size(random), size(random), size(random)));
    scene.instances.push_back({"i", static_cast<std::uint32_t>(i % 2), m});
  }
  EXPECT_GT(expect_same_hits(scene, testing::camera_at({0.1, 0.2, 8.1}, {0, 0, -1})), 500);
  EXPECT_GT(expect_same_hits(scene, testing::camera_at({0.1, 0.2, 0.3}, {0, 0.1, -1})), 400);
}

TEST(Counts, AMailboxSavesTransformations) {
  const Scene scene = testing::scene_of(testing::soup(7, 200, 1.0));
  const SceneTrees trees = build_scene_trees(scene);
  const Camera camera = testing::camera_at({0.05, 0.02, 3.1}, {0, 0, -1});
  TraceOptions none;
  none.object_slots = none.triangle_slots = 0;
  const WorkCounts with = trace_frame(scene, trees, camera, kSide, kSide).work;
  const WorkCounts without = trace_frame(scene, trees, camera, kSide, kSide, none).work;
  EXPECT_LT(with.triangles, without.triangles);
  EXPECT_EQ(without.triangles + without.objects, without.list_entries);
  EXPECT_EQ(with.hits, without.hits);
}

TEST(Counts, StartingInsideTheBoxSavesTheClippingNodes) {
  const Scene scene = testing::scene_of(testing::room(1, 8, 8));
  const SceneTrees trees = build_scene_trees(scene);
  const Camera camera = testing::camera_at({2.013, 1.71, 4.02}, {-0.1, -0.2, -1});
  TraceOptions always;
  always.scene_clipping = always.object_clipping = Clipping::kAlways;
  const WorkCounts inside = trace_frame(scene, trees, camera, kSide, kSide).work;
  const WorkCounts clipped = trace_frame(scene, trees, camera, kSide, kSide, always).work;
  EXPECT_EQ(inside.top_steps, 0u);
  EXPECT_EQ(clipped.top_steps, 6 * clipped.packets);
  EXPECT_GT(clipped.object_steps, inside.object_steps + 5 * clipped.packets);
  EXPECT_EQ(clipped.triangles, inside.triangles);
}

TEST(Counts, TreesByASampleOfRaysTakeLessWork) {
  const Scene scene = testing::scene_of(testing::room(3, 24, 12));
  SceneTrees trees = build_scene_trees(scene);
  const Camera camera = testing::camera_at({2.013, 1.71, 4.02}, {-0.1, -0.2, -1});
  const WorkCounts guided = trace_frame(scene, trees, camera, 128, 128).work;
  TreeOptions unguided;
  unguided.sample_rays = 0;
  trees.objects[0] = build_triangle_tree(scene.objects[0], unguided);
  const WorkCounts not_guided = trace_frame(scene, trees, camera, 128, 128).work;
  EXPECT_LT(guided.bound(), not_guided.bound());
  EXPECT_EQ(guided.hits, not_guided.hits);
}

}  // namespace
}  // namespace dynrt::host
