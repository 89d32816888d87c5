// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Rays exactly through vertices and edges, and through T-junctions.
#include <glm/geometric.hpp>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/reasons.h"
#include "host/analysis/stress/shapes.h"

namespace dynrt::host::stress {

namespace {

constexpr int kHalf = 8;  ///< squares from the lattice's middle to its border

double bumps(int i, int j) { return 1.0 + 0.25 * ((3 * i + 5 * j + 64) % 4); }

/// From the origin to the lattice, from one vertex on, a square apart.
Shot to_lattice(double shift_x, double shift_y) {
  const double step = 1.0 / kHalf;
  return pencil({0, 0, 0}, {(1 - kHalf + shift_x) * step, (1 - kHalf + shift_y) * step, 1},
                {step, 0, 0}, {0, step, 0}, 2 * kHalf - 2, 2 * kHalf - 2);
}

Case lattice_case(const std::string& name, const std::string& about, std::vector<Shot> shots,
                  const Allowed& allowed = {}, const std::string& why = "") {
  return Case(
      name, about,
      [=](Examiner& b) { b.check({.scene = scene_of(lattice(kHalf, bumps)), .shots = shots}); },
      allowed, why);
}

/// From inside the sphere to all its vertices, or to the middles of its edges, the sphere
/// somewhere.
Case sphere_case(const std::string& name, const std::string& about, bool vertices,
                 const glm::dvec3& centre, const Allowed& allowed = {},
                 const std::string& why = "") {
  return Case(
      name, about,
      [=](Examiner& b) {
        Mesh mesh = moved(sphere(b.numbers(), 2), centre);
        for (glm::dvec3& vertex : mesh.vertices) vertex = on_grid(b.numbers(), vertex);
        Trial trial{.scene = scene_of(mesh), .shots = {}};
        const auto aim = [&](const glm::dvec3& at) {
          trial.shots.push_back(ray(centre, at - centre));
        };
        if (vertices) {
          for (const glm::dvec3& vertex : mesh.vertices) aim(vertex);
        } else {
          for (const glm::uvec3& t : mesh.triangles) {
            aim(0.5 * (mesh.vertices[t.x] + mesh.vertices[t.y]));
          }
        }
        b.check(trial);
      },
      allowed, why);
}

void run_cube_corners(Examiner& b) {
  Trial trial{.scene = scene_of(cube(1.0)), .shots = {}};
  for (const double x : {-1.0, 0.0, 0.25, 1.0}) {
    for (const double y : {-1.0, 0.0, 0.25, 1.0}) {
      for (const double z : {-1.0, 0.0, 0.25, 1.0}) {
        if (x != 0 || y != 0 || z != 0) trial.shots.push_back(ray({0, 0, 0}, {x, y, z}));
        trial.shots.push_back(ray({0.25, -0.5, 0.125}, glm::dvec3(x - 0.25, y + 0.5, z - 0.125)));
      }
    }
  }
  b.check(trial);
}

/// A square next to four that are a quarter as high: three of their vertices lie on its edge.
void run_t_junctions(Examiner& b) {
  Mesh mesh;
  add_quad(mesh, {-1, -1, 1}, {1, 0, 0}, {0, 2, 0});
  for (int i = 0; i < 4; ++i) add_quad(mesh, {0, -1 + 0.5 * i, 1}, {1, 0, 0}, {0, 0.5, 0});
  b.check(
      {.scene = scene_of(mesh),
       .shots = {pencil({0, 0, 0}, {-0.25, -0.9375, 1}, {0.0625, 0, 0}, {0, 0.0625, 0}, 9, 31)}});
}

/// The triangles of a lattice one by one: each ray must be claimed by exactly one of them.
void run_one_by_one(Examiner& b) {
  const Mesh whole = lattice(1, bumps);
  const Shot shot = pencil({0, 0, 0}, {-0.875, -0.875, 1}, {0.125, 0, 0}, {0, 0.125, 0}, 15, 15);
  std::vector<unsigned> claims;
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    Mesh one = whole;
    one.triangles = {whole.triangles[i]};
    one.material = {0};
    const Rendered rendered = b.render({.scene = scene_of(one), .shots = {shot}});
    const std::vector<HitRecord>& hits = rendered.frames[0].hits;
    claims.resize(hits.size());
    for (std::size_t p = 0; p < hits.size(); ++p) claims[p] += hits[p].hit;
  }
  for (const unsigned count : claims) {
    if (count == 0) b.count(Fault::kLost, 1);
    if (count > 1) b.count(Fault::kTwice, 1);
  }
}

}  // namespace

std::vector<Case> edge_cases() {
  return {
      lattice_case("vertices", "to every vertex of a bumpy surface of 512 triangles",
                   {to_lattice(0, 0)}, {.lost = 15}, reasons::kCracks),
      lattice_case("edges", "to the middles of its level and upright edges",
                   {to_lattice(0.5, 0), to_lattice(0, 0.5)}, {.lost = 24}, reasons::kCracks),
      lattice_case("diagonals", "to points of its slanting edges",
                   {to_lattice(0.5, 0.5), to_lattice(0.25, 0.25)}, {.lost = 55}, reasons::kCracks),
      lattice_case("beside_vertices", "to points 2^-12 beside its vertices",
                   {to_lattice(0x1p-9, 0x1p-10), to_lattice(-0x1p-10, 0x1p-9)}),
      sphere_case("sphere_vertices", "from the centre of a sphere of 320 triangles to its vertices",
                  true, {0, 0, 0}, {.lost = 12}, reasons::kCracks),
      sphere_case("sphere_edges", "from the centre of the sphere to its edges", false, {0, 0, 0},
                  {.lost = 12}, reasons::kCracks),
      sphere_case("sphere_vertices_at_256", "the same to its vertices, the sphere 256 radii away",
                  true, {256, 0, 0}, {.lost = 53, .distance = 1.9e-3}, reasons::kCracks),
      Case("cube_corners", "from inside a cube to its corners, edges and faces", run_cube_corners),
      Case("t_junctions", "to and around an edge on which three vertices of other triangles lie",
           run_t_junctions),
      Case("silhouette", "past a sphere of 320 triangles, from 3 radii",
           [](Examiner& b) {
             b.check({.scene = scene_of(sphere(b.numbers(), 2)),
                      .shots = {picture({1, 0.75, 3}, {0, 0, 0}, 40, 32, 32)}});
           }),
      Case("one_by_one",
           "eight triangles around a vertex, each tested alone, with rays through edges",
           run_one_by_one, {.twice = 38}, reasons::kSharedEdge),
  };
}

}  // namespace dynrt::host::stress
