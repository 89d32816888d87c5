// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Rays along axes, within planes of trees and triangles.
#include <cmath>

#include "host/analysis/stress/case.h"
#include "host/analysis/stress/shapes.h"
#include "host/tree/assemble.h"
#include "host/tree/grid.h"

namespace dynrt::host::stress {

namespace {

glm::dvec3 axis_vector(int axis, double length) {
  glm::dvec3 v(0.0);
  v[axis] = length;
  return v;
}

/// From inside a cube of 6 x 2 x 4 x 4 triangles, in both directions of the axis, from a lattice of
/// origins that meets vertices, edges and planes of the tree.
void run_along_axis(Examiner& b, int axis) {
  Mesh mesh;
  for (int side = 0; side < 3; ++side) {
    for (const double at : {-1.0, 1.0}) {
      for (int i = -2; i < 2; ++i) {
        for (int j = -2; j < 2; ++j) {
          glm::dvec3 corner(0.0), u(0.0), v(0.0);
          corner[side] = at;
          corner[(side + 1) % 3] = 0.5 * i;
          corner[(side + 2) % 3] = 0.5 * j;
          u[(side + 1) % 3] = v[(side + 2) % 3] = 0.5;
          add_quad(mesh, corner, u, v);
        }
      }
    }
  }
  Trial trial{.scene = scene_of(mesh), .shots = {}};
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      glm::dvec3 origin(0.0);
      origin[axis] = 0.125;
      origin[(axis + 1) % 3] = 0.25 * i;
      origin[(axis + 2) % 3] = 0.25 * j;
      for (const double way : {1.0, -1.0})
        trial.shots.push_back(ray(origin, axis_vector(axis, way)));
    }
  }
  b.check(trial);
}

/// A tree by hand whose planes are at x = -1/2, 0 and 1/2 and walls at z = 1 that begin and end in
/// them; rays whose origin lies in a plane and whose x is zero.
void run_in_splitting_plane(Examiner& b) {
  Mesh mesh;
  for (int i = -2; i < 2; ++i) add_quad(mesh, {0.5 * i, -1, 1}, {0.5, 0, 0}, {0, 2, 0});
  Trial trial{.scene = scene_of(mesh), .shots = {}};
  const Aabb box{{-1, -1, 1}, {1, 1, 1}};
  Tree tree;
  add_clipping_nodes(tree, box);
  tree.root = 7;
  tree.nodes.push_back({0, 0.0, 8, 9});
  tree.nodes.push_back({0, -0.5, 10, 11});
  tree.nodes.push_back({0, 0.5, 12, 13});
  for (std::uint32_t i = 0; i < 4; ++i) {
    tree.nodes.push_back({kLeafAxis, 0, 2 * i, 2});
    tree.items.insert(tree.items.end(), {2 * i, 2 * i + 1});
  }
  SceneTrees trees;
  trees.objects = {tree};
  trees.instances =
      build_instance_tree(trial.scene, std::vector<Aabb>{box}, {.grid = Grid(b.numbers())});
  trial.trees = trees;
  for (const double x : {-0.5, 0.0, 0.5}) {
    for (int j = -7; j < 8; ++j) {
      trial.shots.push_back(ray({x, 0, 0}, {0, 0.125 * j, 1}));
      trial.shots.push_back(ray({x, 0.125 * j, 2}, {0, 0, -1}));
    }
  }
  b.check(trial);
}

/// The floor is the lowest plane of the scene's box: rays in it, with no part upwards, to a post
/// that stands on it.
void run_in_box_plane(Examiner& b) {
  Scene scene = scene_of(moved(cube(0.5), {0, 0.5, 0}));
  Mesh floor;
  add_quad(floor, {-4, 0, -4}, {8, 0, 0}, {0, 0, 8});
  add(scene, floor);
  Trial trial{.scene = scene, .shots = {}};
  for (int i = -7; i < 8; ++i) {
    for (const double way : {1.0, -1.0}) {
      trial.shots.push_back(ray({0.0625 * i, 0, -4 * way}, {0, 0, way}));
      trial.shots.push_back(ray({-6 * way, 0, 0.0625 * i}, {way, 0, 0}));
    }
  }
  b.check(trial);
}

/// Within the plane of 32 triangles, which are not hit by it, to a wall behind them.
void run_in_triangle_plane(Examiner& b) {
  Mesh mesh = wall(2, 4.0, 1.0);
  for (int i = 0; i < 16; ++i) add_quad(mesh, {-0.5, 0, 1 + 0.125 * i}, {1, 0, 0}, {0, 0, 0.125});
  b.check({.scene = scene_of(mesh),
           .shots = {pencil({0, 0, 0}, {-0.234375, 0, 1}, {0.015625, 0, 0}, {0, 0, 0}, 31, 2)}});
}

/// Every component but one as small as the numbers have it, of either sign.
void run_smallest_components(Examiner& b) {
  Trial trial{.scene = scene_of(cube(1.0)), .shots = {}};
  const double least = b.numbers().smallest;
  for (int axis = 0; axis < 3; ++axis) {
    for (int signs = 0; signs < 8; ++signs) {
      glm::dvec3 direction(0.0);
      for (int k = 0; k < 3; ++k) {
        direction[k] = ((signs >> k & 1) != 0 ? -1 : 1) * (k == axis ? 1.0 : least);
      }
      trial.shots.push_back(ray({0.125, 0.25, -0.375}, direction));
      trial.shots.push_back(ray(-4.0 * axis_vector(axis, direction[axis]) + 0.125, direction));
    }
  }
  b.check(trial);
}

}  // namespace

std::vector<Case> plane_cases() {
  return {
      Case("along_x", "from inside a cube of 192 triangles along x, through vertices and edges",
           [](Examiner& b) { run_along_axis(b, 0); }),
      Case("along_y", "the same along y", [](Examiner& b) { run_along_axis(b, 1); }),
      Case("along_z", "the same along z", [](Examiner& b) { run_along_axis(b, 2); }),
      Case("in_splitting_plane",
           "in splitting planes of a tree made by hand, where leaves and triangles meet",
           run_in_splitting_plane),
      Case("in_box_plane", "in the lowest plane of the scene's box, along a floor to a post",
           run_in_box_plane),
      Case("in_triangle_plane", "in the plane of 32 triangles, to a wall behind them",
           run_in_triangle_plane),
      Case("smallest_components", "all components of the direction but one of magnitude 2^-63",
           run_smallest_components),
  };
}

}  // namespace dynrt::host::stress
