// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/candidates.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "host/analysis/truth/embree.h"

namespace dynrt::host {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kGrowth = 0x1p-16;
constexpr double kSlack = 0x1p-15;
constexpr double kStartCube = 1.5;
constexpr double kFarthest = 0x1p22;

float rounded_down(double x) {
  const auto f = static_cast<float>(x);
  return f <= x ? f : std::nextafterf(f, -std::numeric_limits<float>::infinity());
}
float rounded_up(double x) { return -rounded_down(-x); }

/// Data for the callback, behind Embree's own.
struct Query {
  EmbreeContext context;
  CandidateVisitor* visitor;
  double scale;  ///< Embree's distance is scale * t - start
  double start;
};

void meet(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->N != 1 || arguments->valid[0] == 0) return;
  // The context is the first member of a Query, so it has its address.
  const auto* query = reinterpret_cast<const Query*>(arguments->context);
  auto* ray = reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  const double wanted = query->visitor->visit({arguments->geomID, arguments->primID});
  if (wanted == kInfinity) return;
  const double end = query->scale * wanted - query->start;
  const float reach = rounded_up(end * (1 + kSlack) + kSlack);
  // Embree takes a hit's distance from here.
  ray->ray.tfar = std::min(ray->ray.tfar, reach);
}

}  // namespace

struct CandidateTree::State {
  EmbreeDevice device;
  EmbreeScene scene;
  glm::dvec3 centre{0.0};
  double scale = 1.0;

  RTCBounds grown(const CandidateBox& box) const {
    const glm::dvec3 low = (box.low - centre) * scale - kGrowth;
    const glm::dvec3 high = (box.high - centre) * scale + kGrowth;
    RTCBounds bounds{};
    bounds.lower_x = rounded_down(low.x);
    bounds.lower_y = rounded_down(low.y);
    bounds.lower_z = rounded_down(low.z);
    bounds.upper_x = rounded_up(high.x);
    bounds.upper_y = rounded_up(high.y);
    bounds.upper_z = rounded_up(high.z);
    return bounds;
  }

  /// An instance's boxes while Embree builds.
  struct Source {
    const State* state;
    const std::vector<CandidateBox>* boxes;
    static void bounds(const RTCBoundsFunctionArguments* arguments) {
      const auto* source = static_cast<const Source*>(arguments->geometryUserPtr);
      *arguments->bounds_o = source->state->grown((*source->boxes)[arguments->primID]);
    }
  };
};

CandidateTree::CandidateTree(const std::vector<std::vector<CandidateBox>>& boxes)
    : state_(std::make_unique<State>()) {
  glm::dvec3 low(kInfinity);
  glm::dvec3 high(-kInfinity);
  for (const auto& instance : boxes) {
    for (const CandidateBox& box : instance) {
      low = glm::min(low, box.low);
      high = glm::max(high, box.high);
    }
  }
  if (low.x <= high.x) {
    state_->centre = 0.5 * low + 0.5 * high;
    const glm::dvec3 half = high - state_->centre;
    const double largest = std::max({half.x, half.y, half.z, std::numeric_limits<double>::min()});
    state_->scale = std::ldexp(1.0, -(std::ilogb(largest) + 1));
  }
  state_->device.reset(rtcNewDevice(nullptr));
  state_->scene.reset(rtcNewScene(state_->device.get()));
  rtcSetSceneFlags(state_->scene.get(), RTC_SCENE_FLAG_ROBUST);
  std::vector<State::Source> sources;
  sources.reserve(boxes.size());
  for (const auto& instance : boxes) {
    sources.push_back({state_.get(), &instance});
    const RTCGeometry geometry = rtcNewGeometry(state_->device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(instance.size()));
    rtcSetGeometryUserData(geometry, &sources.back());
    rtcSetGeometryBoundsFunction(geometry, State::Source::bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, meet);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(state_->scene.get(), geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(state_->scene.get());
}

CandidateTree::~CandidateTree() = default;

bool CandidateTree::visit(const TruthRay& ray, CandidateVisitor& visitor) const {
  const glm::dvec3 size = glm::abs(ray.direction);
  const double largest = std::max({size.x, size.y, size.z});
  const int exponent = std::ilogb(largest);
  glm::dvec3 direction;
  for (int k = 0; k < 3; ++k) direction[k] = std::ldexp(ray.direction[k], -exponent);
  glm::dvec3 origin = (ray.origin - state_->centre) * state_->scale;
  const glm::dvec3 away = glm::abs(origin);
  if (!(std::max({away.x, away.y, away.z}) <= kFarthest)) return false;

  // Where the ray enters the cube that holds the scene with room to spare, and leaves it.
  double start = 0;
  double end = kInfinity;
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0) {
      if (away[k] > kStartCube) return true;
      continue;
    }
    const double a = (-kStartCube - origin[k]) / direction[k];
    const double b = (kStartCube - origin[k]) / direction[k];
    start = std::max(start, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (start > end) return true;
  origin += start * direction;

  const double scale = std::ldexp(state_->scale, exponent);
  const double from = scale * ray.from - start;
  const double to = std::min(scale * ray.to - start, 8 * kStartCube);
  if (to + kSlack < 0) return true;
  Query query{{}, &visitor, scale, start};
  RTCRayHit hit{};
  hit.ray.org_x = static_cast<float>(origin.x);
  hit.ray.org_y = static_cast<float>(origin.y);
  hit.ray.org_z = static_cast<float>(origin.z);
  hit.ray.dir_x = static_cast<float>(direction.x);
  hit.ray.dir_y = static_cast<float>(direction.y);
  hit.ray.dir_z = static_cast<float>(direction.z);
  hit.ray.tnear = std::max(0.0f, rounded_down(from * (1 - kSlack) - kSlack));
  hit.ray.tfar = rounded_up(to * (1 + kSlack) + kSlack);
  hit.ray.mask = ~0u;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  intersect(state_->scene, query.context, hit);
  return true;
}

}  // namespace dynrt::host
