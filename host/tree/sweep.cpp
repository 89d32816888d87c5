// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/tree/sweep.h"

#include <algorithm>
#include <cmath>

namespace dynrt::host {

namespace {

/// A likelihood from the part of the surface and the part of the rays.
double mixed(double by_surface, std::size_t some, std::size_t all, const TreeCosts& costs) {
  const auto rays = static_cast<double>(all);
  const double weight = costs.surface_rays + costs.surface_share * rays;
  return (by_surface * weight + static_cast<double>(some)) / (weight + rays);
}

}  // namespace

double PlaneSearch::extent(const GridBox& box, int axis) const {
  return grid_.value(box.high[axis]) - grid_.value(box.low[axis]);
}

/// Sorts the faces strictly between `from` and `to`; counts the items that begin at or before
/// `from` and those that end at or beyond `to`.
void PlaneSearch::gather(std::span<const ItemRef> items, int axis, Code from, Code to) {
  lows_.clear();
  highs_.clear();
  flats_.clear();
  below_ = above_ = 0;
  for (const ItemRef& item : items) {
    const Code low = item.box.low[axis];
    const Code high = item.box.high[axis];
    if (low <= from) ++below_;
    if (low > from && low < to) lows_.push_back(low);
    if (high >= to) ++above_;
    if (high > from && high < to) highs_.push_back(high);
    if (low == high && low > from && low < to) flats_.push_back(low);
  }
  std::sort(lows_.begin(), lows_.end());
  std::sort(highs_.begin(), highs_.end());
  std::sort(flats_.begin(), flats_.end());
}

/// Sorts the rays' ends along the axis;
void PlaneSearch::gather(std::span<const RaySpan> rays, int axis) {
  ray_lows_.clear();
  ray_highs_.clear();
  for (const RaySpan& ray : rays) {
    ray_lows_.push_back(std::min(ray.from[axis], ray.to[axis]));
    ray_highs_.push_back(std::max(ray.from[axis], ray.to[axis]));
  }
  std::sort(ray_lows_.begin(), ray_lows_.end());
  std::sort(ray_highs_.begin(), ray_highs_.end());
}

/// Planes are then considered in ascending order.
void PlaneSearch::start_planes(const GridBox& cell, int axis) {
  const double dj = extent(cell, (axis + 1) % 3);
  const double dk = extent(cell, (axis + 2) % 3);
  low_ = grid_.value(cell.low[axis]);
  extent_ = extent(cell, axis);
  const double area = dj * dk + extent_ * (dj + dk);
  cap_ = dj * dk / area;
  rim_ = (dj + dk) / area;
  rays_begun_ = rays_ended_ = 0;
}

PlaneSearch::Likelihood PlaneSearch::likelihood(double position) {
  while (rays_begun_ < ray_lows_.size() && ray_lows_[rays_begun_] < position) ++rays_begun_;
  while (rays_ended_ < ray_highs_.size() && ray_highs_[rays_ended_] <= position) ++rays_ended_;
  const double at = position - low_;
  const std::size_t rays = ray_lows_.size();
  return {mixed(cap_ + at * rim_, rays_begun_, rays, costs_),
          mixed(cap_ + (extent_ - at) * rim_, rays - rays_ended_, rays, costs_)};
}

void PlaneSearch::consider(int axis, Code split, std::size_t left, std::size_t right,
                           std::size_t flat, Plane& best) {
  const Likelihood p = likelihood(grid_.value(split));
  const auto take = [&](std::size_t n_left, std::size_t n_right, bool flat_left) {
    double cost = costs_.step + costs_.item * (p.left * static_cast<double>(n_left) +
                                               p.right * static_cast<double>(n_right));
    if (n_left == 0 || n_right == 0) cost *= 1 - costs_.empty_bonus;
    if (cost < best.cost) best = {cost, axis, split, flat_left, n_left, n_right};
  };
  take(left + flat, right, true);
  if (flat > 0) take(left, right + flat, false);
}

/// Tries every gathered face and the two hair planes, in ascending order.
void PlaneSearch::sweep(const GridBox& cell, int axis, Code from, Code to, Plane& best) {
  const Code low = cell.low[axis];
  const Code high = cell.high[axis];
  const double hair = extent(cell, axis) * costs_.hair;
  const Code after = std::max(grid_.ceil(grid_.value(low) + hair), low + costs_.hair_codes);
  const Code before = std::min(grid_.floor(grid_.value(high) - hair), high - costs_.hair_codes);
  const bool haired = after <= before;

  start_planes(cell, axis);
  std::size_t begun = below_;                      // items with low < split
  std::size_t not_ended = highs_.size() + above_;  // items with high > split
  std::size_t l = 0, h = 0, f = 0;
  constexpr Code kNone = std::numeric_limits<Code>::max();
  bool try_after = haired && after > from && after < to;
  bool try_before = haired && before != after && before > from && before < to;
  while (true) {
    const Code split =
        std::min({l < lows_.size() ? lows_[l] : kNone, h < highs_.size() ? highs_[h] : kNone,
                  try_after ? after : kNone, try_before ? before : kNone});
    if (split == kNone) return;
    if (split == after) try_after = false;
    if (split == before) try_before = false;
    const std::size_t h0 = h;
    while (h < highs_.size() && highs_[h] == split) ++h;
    not_ended -= h - h0;
    const std::size_t f0 = f;
    while (f < flats_.size() && flats_[f] == split) ++f;
    if (!haired || (split >= after && split <= before)) {
      consider(axis, split, begun, not_ended, f - f0, best);
    }
    const std::size_t l0 = l;
    while (l < lows_.size() && lows_[l] == split) ++l;
    begun += l - l0;
  }
}

/// Finds the two of kBins equal slices of the cell around the best of the planes between slices.
void PlaneSearch::narrow(std::span<const ItemRef> items, const GridBox& cell, int axis, Code& from,
                         Code& to) {
  std::vector<Code> planes;
  const double low = grid_.value(cell.low[axis]);
  const double step = extent(cell, axis) / kBins;
  for (int i = 1; i < kBins; ++i) {
    const Code plane = grid_.floor(low + i * step);
    if (plane > cell.low[axis] && plane < cell.high[axis] &&
        (planes.empty() || plane > planes.back())) {
      planes.push_back(plane);
    }
  }
  std::vector<std::size_t> begin(planes.size() + 1), end(planes.size() + 1);
  for (const ItemRef& item : items) {
    ++begin[std::upper_bound(planes.begin(), planes.end(), item.box.low[axis]) - planes.begin()];
    ++end[std::lower_bound(planes.begin(), planes.end(), item.box.high[axis]) - planes.begin()];
  }
  start_planes(cell, axis);
  Plane best;
  std::size_t best_index = 0;
  std::size_t begun = 0, ended = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    begun += begin[i];
    ended += end[i];
    const double before = best.cost;
    consider(axis, planes[i], begun, items.size() - ended, 0, best);
    if (best.cost < before) best_index = i;
  }
  from = best_index > 0 ? planes[best_index - 1] : cell.low[axis];
  to = best_index + 1 < planes.size() ? planes[best_index + 1] : cell.high[axis];
}

Plane PlaneSearch::best(const CellContent& content) {
  const GridBox& cell = content.cell;
  Plane best;
  for (int axis = 0; axis < 3; ++axis) {
    Code from = cell.low[axis];
    Code to = cell.high[axis];
    if (to - from < 2) continue;
    gather(content.rays, axis);
    if (content.items.size() > kSweepLimit) narrow(content.items, cell, axis, from, to);
    gather(content.items, axis, from, to);
    sweep(cell, axis, from, to, best);
  }
  return best;
}

double visit_likelihood(const Grid& grid, const CellContent& part, const CellContent& whole,
                        const TreeCosts& costs) {
  const double by_surface =
      half_area(real_box(grid, part.cell)) / half_area(real_box(grid, whole.cell));
  return mixed(by_surface, part.rays.size(), whole.rays.size(), costs);
}

}  // namespace dynrt::host
