// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/triangle_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "host/error.h"
#include "host/format/memory_format_of.h"
#include "host/test_error.h"
#include "host/tree/test_meshes.h"
#include "host/tree/test_trees.h"

namespace dynrt::host {
namespace {

using testing::add_box;
using testing::add_quad;
using testing::add_triangle;
using testing::expect_sound;
using testing::found;

/// Random points of every triangle lie in leaves that list it, clipping nodes included.
void expect_complete(const Mesh& mesh, const Tree& tree, int points) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    for (int k = 0; k < points; ++k) {
      const double r = std::sqrt(unit(random));
      const double s = unit(random);
      const double u = k < 3 ? k == 0 : 1 - r;
      const double v = k < 3 ? k == 1 : r * (1 - s);
      const glm::dvec3 p =
          u * mesh.vertices[t.x] + v * mesh.vertices[t.y] + (1 - u - v) * mesh.vertices[t.z];
      ASSERT_TRUE(found(tree, tree.clipped_root, p, i))
          << "triangle " << i << " at " << p.x << " " << p.y << " " << p.z;
    }
  }
}

void expect_good(const Mesh& mesh, int points = 20, const Grid& grid = {}) {
  const Tree tree = build_triangle_tree(mesh, {.grid = grid});
  expect_sound(tree, grid);
  expect_complete(mesh, tree, points);
}

TEST(TriangleTree, EveryTriangleIsInEveryLeafThatItTouches) {
  expect_good(testing::soup(1, 3000, 0.1), 50);
  expect_good(testing::soup(2, 300, 2.0), 200);
  expect_good(testing::room(3, 12, 10), 50);
}

TEST(TriangleTree, SoIsItOnCoarseGrids) {
  const Grid narrow(kMemoryFormatOf<hls::Float<5, 8>>);
  expect_good(testing::soup(1, 1000, 0.1), 20, narrow);
  expect_good(testing::room(3, 12, 10), 20, narrow);
  expect_good(testing::room(3, 12, 10), 20, Grid(kMemoryFormatOf<hls::Float<6, 12>>));
  Mesh large = testing::soup(2, 10, 2.0);
  large.vertices[4].z = 7e4;
  EXPECT_THAT([&] { build_triangle_tree(large, {.grid = narrow}); },
              ::testing::ThrowsMessage<UserError>(
                  "object 'soup', triangle 1, vertex 1: z = 70000 is outside the core's numbers; "
                  "coordinates must lie within -65408 and 65408"));
}

TEST(TriangleTree, RectanglesAndEllipsoidsAreInEveryLeafThatTheyTouch) {
  Mesh mesh = testing::soup(8, 60, 0.3);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> at(-1, 1);
  const auto vector = [&](double size) {
    return size * glm::dvec3(at(random), at(random), at(random));
  };
  for (int i = 0; i < 40; ++i) {
    mesh.rectangles.push_back({vector(1), vector(0.5), vector(0.5)});
    const glm::dmat3 axes(vector(0.3), vector(0.3), vector(0.3));
    glm::dmat4 from_unit(axes);
    from_unit[3] = glm::dvec4(vector(1), 1);
    mesh.ellipsoids.push_back({from_unit});
  }
  const Tree tree = build_triangle_tree(mesh);
  expect_sound(tree);
  expect_complete(mesh, tree, 20);
  const auto expect_found = [&](const glm::dvec3& p, std::uint32_t item) {
    ASSERT_TRUE(found(tree, tree.clipped_root, p, item))
        << "primitive " << item << " at " << p.x << " " << p.y << " " << p.z;
  };
  for (std::uint32_t i = 60; i < mesh.primitives(); ++i) {
    for (int k = 0; k < 300; ++k) {
      if (mesh.is_rectangle(i)) {
        const Rectangle& r = mesh.rectangle(i);
        expect_found(
            r.corner + (0.5 + 0.5 * at(random)) * r.across + (0.5 + 0.5 * at(random)) * r.along, i);
      } else {
        const glm::dvec3 on_sphere = glm::normalize(vector(1));
        expect_found(mesh.ellipsoid(i).from_unit * glm::dvec4(on_sphere, 1), i);
      }
    }
  }
}

TEST(TriangleTree, OneTriangle) {
  Mesh mesh;
  add_triangle(mesh, {0.1, 0.2, 0.3}, {1.1, 0.2, 0.4}, {0.3, 0.9, 0.7});
  expect_good(mesh, 1000);
}

TEST(TriangleTree, ManyTrianglesInOnePlane) {
  for (int axis = 0; axis < 3; ++axis) {
    Mesh mesh = testing::soup(4, 500, 0.2);
    for (glm::dvec3& p : mesh.vertices) p[axis] = 0.1;
    expect_good(mesh);
    for (glm::dvec3& p : mesh.vertices) p[axis] = 0.0;
    expect_good(mesh);
  }
}

TEST(TriangleTree, TheSameTriangleManyTimes) {
  Mesh mesh;
  for (int i = 0; i < 300; ++i) add_triangle(mesh, {0, 0, 0}, {1, 0.5, 0}, {0, 1, 0.25});
  expect_good(mesh);
}

TEST(TriangleTree, FlatBoxesAndWallsOnTheBox) {
  Mesh mesh;
  add_box(mesh, {0, 0, 0}, {1, 1, 0});
  add_box(mesh, {0, 0.5, 0}, {1, 0.5, 1});
  add_box(mesh, {0.3, 0, 0}, {0.3, 1, 1});
  for (int i = 0; i < 10; ++i) add_quad(mesh, {0, 0, 0.1 * i}, {1, 0, 0}, {0, 1, 0});
  expect_good(mesh, 200);
}

TEST(TriangleTree, TinyHugeAndFarAway) {
  for (const double scale : {1e-15, 1e-6, 1e6, 1e18}) {
    Mesh mesh = testing::soup(5, 400, 0.3);
    for (glm::dvec3& p : mesh.vertices) p *= scale;
    expect_good(mesh);
  }
  Mesh mesh = testing::soup(6, 400, 0.3);
  for (glm::dvec3& p : mesh.vertices) p += 4096.0;
  expect_good(mesh);
  Mesh mixed = testing::soup(7, 400, 0.3);
  for (std::size_t i = 0; i < mixed.vertices.size(); i += 3) {
    mixed.vertices[i] *= std::pow(10.0, static_cast<double>(i % 17));
  }
  expect_good(mixed);
}

TEST(TriangleTree, SmallerThanTheGrid) {
  Mesh mesh = testing::soup(8, 100, 1e-7);
  for (glm::dvec3& p : mesh.vertices) p = 1000.0 + p * 1e-6;
  expect_good(mesh);
}

TEST(TriangleTree, WallsOnTheFacesOfACellAreCutFromTheEmptyRoom) {
  Mesh mesh;  // a cube whose faces are 4 x 4 quads
  for (int i = 0; i < 16; ++i) {
    const double a = i % 4, b = i / 4;
    for (const double c : {0.0, 4.0}) {
      add_quad(mesh, {a, b, c}, {1, 0, 0}, {0, 1, 0});
      add_quad(mesh, {c, a, b}, {0, 1, 0}, {0, 0, 1});
      add_quad(mesh, {b, c, a}, {0, 0, 1}, {1, 0, 0});
    }
  }
  const Tree tree = build_triangle_tree(mesh);
  std::uint32_t index = tree.root;
  const glm::dvec3 inside{2.2, 1.7, 2.6};
  while (index != kNullNode && !tree.nodes[index].is_leaf()) {
    const TreeNode& node = tree.nodes[index];
    index = inside[node.axis] < node.split ? node.left : node.right;
  }
  EXPECT_EQ(index, kNullNode);
}

TEST(TriangleTree, IsTheSameTwice) {
  const Mesh mesh = testing::soup(9, 20000, 0.05);
  testing::expect_same(build_triangle_tree(mesh), build_triangle_tree(mesh));
}

TEST(TriangleTree, MoreTrianglesThanOneSweepTakes) {
  expect_good(testing::soup(10, 70000, 0.02), 4);
}

std::string error_of(const Mesh& mesh) {
  return user_error([&] { build_triangle_tree(mesh); });
}

TEST(TriangleTree, RefusesAnObjectWithoutTriangles) {
  Mesh mesh;
  mesh.name = "nothing";
  EXPECT_EQ(error_of(mesh), "object 'nothing' has no triangles; an object must have at least one");
}

TEST(TriangleTree, RefusesCoordinatesBeyondTheCoresNumbers) {
  Mesh mesh = testing::soup(11, 3, 0.3);
  mesh.vertices[4].y = 4e19;
  EXPECT_EQ(error_of(mesh),
            "object 'soup', triangle 1, vertex 1: y = 4e+19 is outside the core's numbers; "
            "coordinates must lie within -1.8447e+19 and 1.8447e+19");
  mesh.vertices[4].y = std::nan("");
  EXPECT_EQ(error_of(mesh),
            "object 'soup', triangle 1, vertex 1: y = nan is outside the core's numbers; "
            "coordinates must lie within -1.8447e+19 and 1.8447e+19");
}

}  // namespace
}  // namespace dynrt::host
