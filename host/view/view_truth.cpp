// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/view_truth.h"

#include <algorithm>
#include <cmath>

#include "host/analysis/truth/rays.h"
#include "host/analysis/truth/truth.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(HitPlace place) {
  if (place == HitPlace::kVertex) return "on a vertex";
  return place == HitPlace::kEdge ? "on an edge" : "inside";
}

/// From the true number to the core's, in steps of the core's numbers around the true one.
double in_last_places(double found, double exact, const MemoryFormat& format) {
  const double size = std::max(std::abs(exact), format.smallest);
  return (found - exact) /
         std::ldexp(1.0, std::ilogb(size) - static_cast<int>(format.mantissa_bits));
}

Json differences(const HitRecord& hit, double t, double u, double v, double cosine,
                 const MemoryFormat& format) {
  const auto off = [&](std::uint32_t bits, double exact) {
    return in_last_places(format.number(bits), exact, format);
  };
  return {{"t", off(hit.t, t)},
          {"u", off(hit.u, u)},
          {"v", off(hit.v, v)},
          {"cosine", off(hit.cosine, cosine)}};
}

Verdict verdict_of(const std::optional<TruthHit>& exact, bool found,
                   const std::optional<PrimitiveId>& primitive) {
  if (!exact) return found ? Verdict::kNothingThere : Verdict::kRight;
  if (!found) return Verdict::kMissed;
  return primitive && exact->tied_with(*primitive) ? Verdict::kRight : Verdict::kOther;
}

class ExactTruth final : public ViewTruth {
 public:
  explicit ExactTruth(const Scene& scene) : truth_(scene) {}

  Json pixel(const FrameRays& rays, unsigned x, unsigned y, const HitRecord& hit,
             const std::optional<PrimitiveId>& primitive,
             const MemoryFormat& format) const override {
    const TruthRay ray = primary_ray(rays.camera, rays.width, rays.height, x, y);
    const std::optional<TruthHit> exact = truth_.nearest(ray);
    Json json = {{"hit", exact.has_value()},
                 {"verdict", static_cast<int>(verdict_of(exact, hit.hit, primitive))}};
    if (exact) {
      const TruthHit& h = *exact;
      json["instance"] = h.id.instance;
      json["primitive"] = h.id.primitive;
      json["t"] = h.t;
      json["u"] = h.u;
      json["v"] = h.v;
      json["cosine"] = h.cosine;
      json["place"] = name_of(h.place);
      json["ties"] = h.ties.size();
    }
    if (!primitive) return json;
    // The core's primitive may be another; then its own numbers are the ones to compare with.
    if (const auto own = truth_.intersect(ray, *primitive)) {
      json["off"] = differences(hit, own->t, own->u, own->v, own->cosine, format);
    }
    return json;
  }

  std::vector<Verdict> verdicts(
      const FrameRays& rays,
      std::span<const std::optional<PrimitiveId>> primitives) const override {
    std::vector<TruthRay> all;
    all.reserve(primitives.size());
    for (unsigned y = 0; y < rays.height; ++y) {
      for (unsigned x = 0; x < rays.width; ++x) {
        all.push_back(primary_ray(rays.camera, rays.width, rays.height, x, y));
      }
    }
    const auto exact = truth_.nearest(all);
    std::vector<Verdict> verdicts;
    verdicts.reserve(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      verdicts.push_back(verdict_of(exact[i], primitives[i].has_value(), primitives[i]));
    }
    return verdicts;
  }

 private:
  Truth truth_;
};

}  // namespace

std::unique_ptr<ViewTruth> ViewTruth::of(const Scene& scene) {
  return std::make_unique<ExactTruth>(scene);
}

}  // namespace dynrt::host
