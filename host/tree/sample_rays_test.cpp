// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/sample_rays.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "host/tree/test_meshes.h"
#include "host/tree/triangle_tree.h"

namespace dynrt::host {
namespace {

Tree unguided(const Mesh& mesh) {
  TreeOptions options;
  options.sample_rays = 0;
  return build_triangle_tree(mesh, options);
}

/// Distance of the closest triangle along a ray, by brute force; 1 is the ray's end.
double closest(const Mesh& mesh, const RaySpan& ray) {
  double best = std::numeric_limits<double>::infinity();
  const glm::dvec3 along = ray.to - ray.from;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3& c = mesh.vertices[t.z];
    const glm::dmat3 m(mesh.vertices[t.x] - c, mesh.vertices[t.y] - c, -along);
    const glm::dvec3 uvt = glm::inverse(m) * (ray.from - c);
    if (uvt.x >= 0 && uvt.y >= 0 && uvt.x + uvt.y <= 1 && uvt.z > 1e-9)
      best = std::min(best, uvt.z);
  }
  return best;
}

bool on_box(const Aabb& box, const glm::dvec3& p) {
  bool on = false;
  for (int axis = 0; axis < 3; ++axis) {
    on =
        on || std::abs(p[axis] - box.low[axis]) < 1e-9 || std::abs(p[axis] - box.high[axis]) < 1e-9;
  }
  return on;
}

TEST(SampleRays, EndAtTheirFirstHitOrAtTheBox) {
  for (const Mesh& mesh : {testing::room(2, 4, 6), testing::soup(1, 400, 0.3)}) {
    const Tree tree = unguided(mesh);
    const std::vector<RaySpan> rays = sample_rays(mesh, tree, 800);
    EXPECT_GT(rays.size(), 400u);
    int hits = 0;
    for (const RaySpan& ray : rays) {
      if (glm::length(ray.to - ray.from) < 1e-6) continue;  // hits a wall on the box
      const double t = closest(mesh, ray);
      ASSERT_GE(t, 1 - 1e-6);
      if (t < 1 + 1e-6) {
        ++hits;
      } else {
        ASSERT_TRUE(on_box(tree.box, ray.to));
      }
    }
    EXPECT_GT(hits, 100);
  }
}

TEST(SampleRays, StartInTheRoomButOutsideOfAThing) {
  const Mesh room = testing::room(2, 4, 6);
  const Tree room_tree = unguided(room);
  for (const RaySpan& ray : sample_rays(room, room_tree, 800)) {
    ASSERT_TRUE(room_tree.box.holds(ray.from));
  }
  Mesh quad;  // nearly every ray from within its box leaves it
  testing::add_quad(quad, {0, 0, 0}, {1, 0, 0}, {0, 1, 0.01});
  testing::add_quad(quad, {0, 0, 1}, {0.01, 0, 0}, {0, 0.01, 0});
  const Tree quad_tree = unguided(quad);
  std::size_t outside = 0;
  const std::vector<RaySpan> rays = sample_rays(quad, quad_tree, 800);
  for (const RaySpan& ray : rays) outside += on_box(quad_tree.box, ray.from);
  EXPECT_GT(outside, rays.size() / 2);
}

TEST(SampleRays, AreTheSameTwice) {
  const Mesh mesh = testing::soup(1, 400, 0.3);
  const Tree tree = unguided(mesh);
  const std::vector<RaySpan> a = sample_rays(mesh, tree, 100);
  const std::vector<RaySpan> b = sample_rays(mesh, tree, 100);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].from, b[i].from);
    ASSERT_EQ(a[i].to, b[i].to);
  }
}

}  // namespace
}  // namespace dynrt::host
