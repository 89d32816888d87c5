// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Finds the plane that splits a cell at the least expected cost by the surface-area heuristic. All
// positions are codes of the number grid. Candidates are the faces of the items' boxes and, on each
// axis, two planes a hair off the cell's own faces: they separate walls on a cell's face from the
// empty space before it, which no plane through an item's face can do.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "host/tree/grid_box.h"

namespace dynrt::host {

/// The weights of the heuristic.
struct TreeCosts {
  double step = 1;            ///< of an inner node
  double item = 1.25;         ///< of an item in a leaf
  double empty_bonus = 0.2;   ///< part of a plane's cost forgiven where one side is empty
  double hair = 1.0 / 16384;  ///< of the cell's extent
  int hair_codes = 4;         ///< and at least so many numbers of the grid
  /// The number of sample rays (RaySpan) that the surface area counts for: a constant, and a share
  /// of their number.
  double surface_rays = 16;
  double surface_share = 0.3;
};

/// An item and its part within a cell.
struct ItemRef {
  GridBox box;
  std::uint32_t item = 0;
};

/// The part of a sample ray within a cell, from its start to its hit. The rays that reach a child
/// give the likelihood that it is visited; if they are few, its surface does. The surface alone
/// ignores that objects hide others and that rays start inside a room.
struct RaySpan {
  glm::dvec3 from, to;
};

/// The items and rays in a cell.
struct CellContent {
  GridBox cell;
  std::vector<ItemRef> items;
  std::vector<RaySpan> rays;
};

struct Plane {
  double cost = std::numeric_limits<double>::infinity();
  int axis = -1;  ///< -1: there is none
  Code split = 0;
  bool flat_left = true;  ///< items that lie in the plane go to the left child
  std::size_t left = 0;   ///< items in each child
  std::size_t right = 0;
};

/// Finds the same plane for the same items in any order: of planes of equal cost, the one with the
/// lowest axis and split. Holds the working memory of one thread.
class PlaneSearch {
 public:
  PlaneSearch(const Grid& grid, const TreeCosts& costs) : grid_(grid), costs_(costs) {}
  Plane best(const CellContent& content);

 private:
  /// Sets of more items are counted at kBins planes first, and then at the faces near the best
  /// plane.
  static constexpr std::size_t kSweepLimit = 1 << 16;
  static constexpr int kBins = 512;

  struct Likelihood {
    double left, right;
  };

  double extent(const GridBox& box, int axis) const;
  void gather(std::span<const ItemRef> items, int axis, Code from, Code to);
  void gather(std::span<const RaySpan> rays, int axis);
  void sweep(const GridBox& cell, int axis, Code from, Code to, Plane& best);
  void narrow(std::span<const ItemRef> items, const GridBox& cell, int axis, Code& from, Code& to);
  void start_planes(const GridBox& cell, int axis);
  Likelihood likelihood(double position);
  void consider(int axis, Code split, std::size_t left, std::size_t right, std::size_t flat,
                Plane& best);

  Grid grid_;
  TreeCosts costs_;
  std::vector<Code> lows_, highs_, flats_;
  std::size_t below_ = 0, above_ = 0;
  std::vector<double> ray_lows_, ray_highs_;
  std::size_t rays_begun_ = 0, rays_ended_ = 0;      ///< below the plane considered last
  double low_ = 0, extent_ = 0, cap_ = 0, rim_ = 0;  ///< of the cell along the axis
};

/// The likelihood that a ray that meets a cell meets its part.
double visit_likelihood(const Grid& grid, const CellContent& part, const CellContent& whole,
                        const TreeCosts& costs);

}  // namespace dynrt::host
