// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/scatter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

namespace dynrt::host {

namespace {

constexpr std::size_t kTriesEach = 64;  // throws for every instance, on average

class Spots {
 public:
  explicit Spots(double apart) : apart_(apart) {}

  // Takes the spot unless another one is too near.
  bool take(const glm::dvec2& at) {
    if (!(apart_ > 0.0)) return true;
    const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x / apart_)); };
    const std::int64_t i = cell(at.x), j = cell(at.y);
    for (std::int64_t k = i - 1; k <= i + 1; ++k) {
      for (std::int64_t l = j - 1; l <= j + 1; ++l) {
        const auto found = taken_.find({k, l});
        if (found == taken_.end()) continue;
        for (const glm::dvec2& other : found->second) {
          if (glm::distance(at, other) < apart_) return false;
        }
      }
    }
    taken_[{i, j}].push_back(at);
    return true;
  }

 private:
  const double apart_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<glm::dvec2>>
      taken_;  // by cell of that side
};

// The height of the mesh's highest triangle above (x, z).
std::optional<double> height(const Mesh& mesh, const glm::dvec2& at) {
  std::optional<double> highest;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 &a = mesh.vertices[t.x], &b = mesh.vertices[t.y], &c = mesh.vertices[t.z];
    const auto side = [&](const glm::dvec3& p, const glm::dvec3& q) {
      return (q.x - p.x) * (at.y - p.z) - (q.z - p.z) * (at.x - p.x);
    };
    const double u = side(b, c), v = side(c, a), w = side(a, b), area = u + v + w;
    const bool inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    if (!inside || area == 0.0) continue;
    const double y = (u * a.y + v * b.y + w * c.y) / area;
    highest = std::max(highest.value_or(y), y);
  }
  return highest;
}

}  // namespace

std::vector<glm::dmat4> scatter(const Scatter& wanted) {
  std::mt19937 engine(wanted.seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 32>(engine);
  };
  std::vector<glm::dmat4> placed;
  Spots spots(wanted.apart);
  for (std::size_t tries = kTriesEach * wanted.count; placed.size() < wanted.count && tries > 0;
       --tries) {
    // In this order, and always all four, so that a refused instance does not change later ones.
    const double x = between(wanted.from.x, wanted.to.x), z = between(wanted.from.y, wanted.to.y);
    const double turn = between(0.0, 2.0 * std::numbers::pi);
    const double size = between(wanted.scale.x, wanted.scale.y);
    const bool is_clear =
        std::any_of(wanted.clear.begin(), wanted.clear.end(), [&](const glm::dvec3& circle) {
          return glm::distance(glm::dvec2(x, z), glm::dvec2(circle)) < circle.z;
        });
    if (is_clear) continue;
    const std::optional<double> y = wanted.ground == nullptr ? 0.0 : height(*wanted.ground, {x, z});
    if (!y || !spots.take({x, z})) continue;
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), {x, *y, z});
    placed.push_back(glm::scale(glm::rotate(moved, turn, {0, 1, 0}), glm::dvec3(size)));
  }
  return placed;
}

}  // namespace dynrt::host
