// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Finds the plane that splits a cell at the least expected cost by the surface-area heuristic. All
// positions are codes of the number grid. Candidates are the faces of the items' boxes and, on each
// axis, two planes a hair off the cell's own faces: they cut walls lying on a cell's face from the
// empty room before it, which no plane through an item's face does.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "host/tree/grid_box.h"

namespace dynrt::host {

/// What the heuristic weighs.
struct TreeCosts {
  double step = 1;            ///< of an inner node
  double item = 1.25;         ///< of an item in a leaf
  double empty_bonus = 0.2;   ///< part of a plane's cost forgiven where one side is empty
  double hair = 1.0 / 16384;  ///< of the cell's extent
  int hair_codes = 4;         ///< and at least so many numbers of the grid
  /// How many sample rays (RaySpan) the surface area counts for: so many, and a share of their
  /// number.
  double surface_rays = 16;
  double surface_share = 0.3;
};

/// An item and its part within a cell.
struct ItemRef {
  GridBox box;
  std::uint32_t item = 0;
};

/// The part of a sample ray within a cell, from where it starts to what it hits. How likely a child
/// is to be visited is judged by the rays that reach it, and where these are few by its surface:
/// the surface alone knows nothing of what hides behind what, nor that rays start inside a room.
struct RaySpan {
  glm::dvec3 from, to;
};

/// What lies in a cell.
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

/// The same plane for the same items in any order: of planes of equal cost the one of the lowest
/// axis and split is returned. Holds the working memory of one thread.
class PlaneSearch {
 public:
  PlaneSearch(const Grid& grid, const TreeCosts& costs) : grid_(grid), costs_(costs) {}
  Plane best(const CellContent& content);

 private:
  /// More items than these are counted at kBins planes first, and then at the faces near the best.
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

/// How likely a ray that meets a cell is to meet its part.
double visit_likelihood(const Grid& grid, const CellContent& part, const CellContent& whole,
                        const TreeCosts& costs);

}  // namespace dynrt::host
