// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

#include "host/picture/image_library.h"

namespace dynrt::host {

namespace {

using nlohmann::ordered_json;

constexpr MeasureDefinition kMeasures[] = {
    {"primary", "rays", "rays", "-", "primary rays: one for each pixel of the image"},
    {"primary", "hits", "rays", "-", "rays that truly hit something"},
    {"primary", "missed", "rays", "less", "rays that hit something but whose record names no hit"},
    {"primary", "false", "rays", "less", "rays that hit nothing but whose record names a hit"},
    {"primary", "wrong_triangle", "rays", "less",
     "rays whose record names a primitive that is not the nearest, not tied with it and not its "
     "neighbour"},
    {"primary", "neighbour", "rays", "less",
     "rays whose record names another primitive that shares a vertex or an edge with the nearest"},
    {"primary", "ties", "rays", "-",
     "rays whose record names another primitive that the ray truly hits at exactly the same "
     "distance, which is as right as the nearest"},
    {"primary", "wrong_share", "1", "less", "(missed + false + wrong_triangle) / rays"},
    {"primary", "double", "rays", "-",
     "rays that hit two primitives at a shared edge; a frame cannot show them, as it records one "
     "hit for each ray, but the mass test of closed meshes counts them"},
    {"primary", "t_median", "1", "less",
     "relative error of the distance, abs(t - t') / t', where the record names the nearest "
     "primitive, one tied with it or a neighbour: the median of these rays"},
    {"primary", "t_p99", "1", "less",
     "relative error of the distance, as t_median: 99 % of the rays do not exceed it"},
    {"primary", "t_max", "1", "less", "relative error of the distance, as t_median: the largest"},
    {"primary", "u_p99", "1", "less",
     "error of u, abs(u - u'), where the record names the nearest primitive: 99 % of these rays do "
     "not exceed it"},
    {"primary", "u_max", "1", "less", "error of u, as u_p99: the largest"},
    {"primary", "v_p99", "1", "less",
     "error of v, abs(v - v'), where the record names the nearest primitive: 99 % of these rays do "
     "not exceed it"},
    {"primary", "v_max", "1", "less", "error of v, as v_p99: the largest"},
    {"primary", "cosine_p99", "1", "less",
     "error of the cosine of ray and normal, the ray's direction taken as of length 1, where the "
     "record names the nearest primitive: 99 % of these rays do not exceed it"},
    {"primary", "cosine_max", "1", "less", "error of the cosine, as cosine_p99: the largest"},
    {"light", "rays", "rays", "-",
     "light rays: one from each light for each surface that a ray hits"},
    {"light", "shadows", "rays", "-", "light rays that do not reach the surface"},
    {"light", "judged", "rays", "-",
     "light rays whose result the pixel shows: they go to a surface that is no mirror, that the "
     "primary ray hit correctly, and whose colour changes visibly without the light"},
    {"light", "missed", "rays", "less", "judged light rays whose shadow is missing in the picture"},
    {"light", "false", "rays", "less",
     "judged light rays with a shadow in the picture where there is none"},
    {"light", "unexplained", "pixels", "less",
     "pixels without a mirror whose primary ray hit correctly, whose colour differs by more than "
     "rounding, and whose difference no choice of shadows explains"},
    {"light", "wrong_share", "1", "less", "(missed + false) / judged"},
    {"reflection", "rays", "rays", "-", "reflected rays of all bounces"},
    {"reflection", "hits", "rays", "-", "reflected rays that hit something"},
    {"reflection", "judged", "pixels", "-", "pixels whose primary ray correctly hit a mirror"},
    {"reflection", "wrong", "pixels", "less",
     "judged pixels whose colour differs by more than rounding, from the mirrored surfaces or from "
     "the light on the mirror"},
    {"reflection", "wrong_share", "1", "less", "wrong / judged"},
    {"image", "pixels", "pixels", "-", "pixels of the image"},
    {"image", "differ", "pixels", "less", "pixels that differ from the true picture in any bit"},
    {"image", "differ_share", "1", "less", "differ / pixels"},
    {"image", "differ_by_10", "pixels", "less",
     "pixels in which a channel differs by more than 10 levels of 255"},
    {"image", "psnr", "dB", "more",
     "20 log10(1 / rms) over all channels, 1 being white; null if the pictures are the same"},
    {"image", "rms", "levels", "less",
     "root of the mean square difference over all channels, in levels of 255"},
    {"image", "mean", "levels", "less", "mean difference over all channels, in levels of 255"},
    {"image", "largest", "levels", "less", "the largest difference of a channel, in levels of 255"},
};

/// The measures of one group, each set once and in the table's order.
class Group {
 public:
  explicit Group(const std::string& group) {
    for (const MeasureDefinition& m : kMeasures) {
      if (group == m.group) figures_[m.name] = nullptr;
    }
  }
  ordered_json& operator[](const char* name) { return figures_.at(name); }
  ordered_json take() { return std::move(figures_); }

 private:
  ordered_json figures_ = ordered_json::object();
};

ordered_json ratio(double a, double b) { return b > 0 ? ordered_json(a / b) : ordered_json(); }

struct Errors {
  std::vector<double> values;

  void add(double error) { values.push_back(std::abs(error)); }
  /// The value that this share of them does not exceed; null if there are none.
  ordered_json quantile(double part) {
    if (values.empty()) return nullptr;
    const auto rank =
        static_cast<std::ptrdiff_t>(std::ceil(part * static_cast<double>(values.size())) - 1);
    const auto at = values.begin() + std::max<std::ptrdiff_t>(rank, 0);
    std::ranges::nth_element(values, at);
    return *at;
  }
  ordered_json largest() const {
    return values.empty() ? ordered_json() : ordered_json(std::ranges::max(values));
  }
};

/// A channel's level of 0x00BBGGRR.
int level(std::uint32_t pixel, std::size_t channel) {
  return static_cast<int>((pixel >> (8 * channel)) & 255);
}

class Judge {
 public:
  Judge(const Truth& truth, const TruthFrame& expected, const Frame& frame,
        const MatrixOwners& owners, const NumberOf& number)
      : truth_(truth), expected_(expected), frame_(frame), owners_(owners), number_(number) {}

  ordered_json all() {
    ordered_json out;
    out["primary"] = primary();
    if (!expected_.light_rays.empty()) out["light"] = light();
    if (!expected_.reflections.empty()) out["reflection"] = reflection();
    out["image"] = image();
    return out;
  }

 private:
  ordered_json primary() {
    std::uint64_t missed = 0, ghosts = 0, wrong = 0, neighbours = 0, ties = 0;
    Errors t, u, v, cosine;
    right_.assign(expected_.hits.size(), false);
    for (std::size_t i = 0; i < expected_.hits.size(); ++i) {
      const auto& hit = expected_.hits[i];
      const HitRecord& record = frame_.hits[i];
      if (!hit || !record.hit) {
        missed += hit.has_value();
        ghosts += record.hit;
        right_[i] = !hit && !record.hit;
        continue;
      }
      const auto id = owners_.of(record.object, record.triangle);
      const bool same = id == hit->id;
      const bool tied = id && hit->tied_with(*id);
      right_[i] = tied;
      if (!tied && !(id && truth_.touch(*id, hit->id))) {
        ++wrong;
        continue;
      }
      ties += tied && !same;
      neighbours += !tied;
      t.add((number_(record.t) - hit->t) / hit->t);
      if (!same) continue;
      u.add(number_(record.u) - hit->u);
      v.add(number_(record.v) - hit->v);
      cosine.add((number_(record.cosine) - hit->cosine) / glm::length(expected_.rays[i].direction));
    }
    Group out("primary");
    out["rays"] = expected_.hits.size();
    out["hits"] = expected_.hit_count();
    out["missed"] = missed;
    out["false"] = ghosts;
    out["wrong_triangle"] = wrong;
    out["neighbour"] = neighbours;
    out["ties"] = ties;
    out["wrong_share"] = ratio(static_cast<double>(missed + ghosts + wrong),
                               static_cast<double>(expected_.hits.size()));
    out["t_median"] = t.quantile(0.5);
    out["t_p99"] = t.quantile(0.99);
    out["t_max"] = t.largest();
    out["u_p99"] = u.quantile(0.99);
    out["u_max"] = u.largest();
    out["v_p99"] = v.quantile(0.99);
    out["v_max"] = v.largest();
    out["cosine_p99"] = cosine.quantile(0.99);
    out["cosine_max"] = cosine.largest();
    return out.take();
  }

  /// Levels that brightness rounded otherwise may cost: a step of ambient light and of each light.
  int tolerance() const { return 2 + static_cast<int>(expected_.shading.lights); }

  /// How far a pixel is off if its sum were this.
  int off(std::size_t pixel, const Sixteenths& sum) const {
    int largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int is = level(frame_.pixels[pixel], k);
      largest = std::max(largest, std::abs(is - static_cast<int>(std::min(sum[k] / 16, 255u))));
    }
    return largest;
  }

  ordered_json light() {
    std::vector<std::vector<const LightRayTruth*>> of_pixel(expected_.pixels.size());
    std::vector<bool> mirror(expected_.pixels.size(), false);
    std::uint64_t shadows = 0;
    for (const LightRayTruth& ray : expected_.light_rays) {
      shadows += ray.shadow;
      if (ray.bounce == 0) of_pixel[ray.pixel].push_back(&ray);
    }
    for (const ReflectionTruth& ray : expected_.reflections) mirror[ray.pixel] = true;

    std::uint64_t judged = 0, missed = 0, dark = 0, unexplained = 0;
    for (std::size_t p = 0; p < of_pixel.size(); ++p) {
      if (!right_[p] || mirror[p] || of_pixel[p].empty()) continue;
      std::erase_if(of_pixel[p], [&](const LightRayTruth* ray) {
        return static_cast<int>(std::ranges::max(ray->adds) / 16) < 3 * tolerance();
      });
      const auto& rays = of_pixel[p];
      judged += rays.size();
      const auto wrong = explanation(p, rays);
      if (!wrong) {
        ++unexplained;
        continue;
      }
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if ((*wrong >> i & 1) == 0) continue;
        ++(rays[i]->shadow ? missed : dark);
      }
    }
    Group out("light");
    out["rays"] = expected_.light_rays.size();
    out["shadows"] = shadows;
    out["judged"] = judged;
    out["missed"] = missed;
    out["false"] = dark;
    out["unexplained"] = unexplained;
    out["wrong_share"] = ratio(static_cast<double>(missed + dark), static_cast<double>(judged));
    return out.take();
  }

  /// Which of a pixel's light rays found wrong, as bits: the fewest that explain its colour.
  std::optional<unsigned> explanation(std::size_t pixel,
                                      const std::vector<const LightRayTruth*>& rays) const {
    // The light that reaches the pixel without these rays; the sums are cut off at white.
    Sixteenths rest = expected_.unlimited[pixel];
    for (const LightRayTruth* ray : rays) {
      for (std::size_t k = 0; k < 3 && !ray->shadow; ++k) rest[k] -= ray->adds[k];
    }
    std::optional<unsigned> best;
    for (unsigned wrong = 0; wrong < 1u << rays.size(); ++wrong) {
      if (best && std::popcount(wrong) >= std::popcount(*best)) continue;
      Sixteenths sum = rest;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool dark = rays[i]->shadow != ((wrong >> i & 1) != 0);
        for (std::size_t k = 0; k < 3 && !dark; ++k) sum[k] += rays[i]->adds[k];
      }
      if (off(pixel, sum) <= tolerance()) best = wrong;
    }
    return best;
  }

  ordered_json reflection() {
    std::uint64_t hits = 0, judged = 0, wrong = 0;
    for (const ReflectionTruth& ray : expected_.reflections) {
      hits += ray.hit.has_value();
      if (ray.bounce != 1 || !right_[ray.pixel]) continue;
      ++judged;
      wrong += off(ray.pixel, expected_.unlimited[ray.pixel]) > tolerance();
    }
    Group out("reflection");
    out["rays"] = expected_.reflections.size();
    out["hits"] = hits;
    out["judged"] = judged;
    out["wrong"] = wrong;
    out["wrong_share"] = ratio(static_cast<double>(wrong), static_cast<double>(judged));
    return out.take();
  }

  ordered_json image() const {
    constexpr float kTenLevels = 10.5F / 255;
    const PictureView expected(frame_.width, frame_.height, expected_.pixels);
    const PictureDifference found = image_library().difference(expected, frame_, kTenLevels);
    std::uint64_t differ = 0;
    for (std::size_t i = 0; i < frame_.pixels.size(); ++i) {
      differ += (frame_.pixels[i] ^ expected_.pixels[i]) << 8 != 0;
    }
    Group out("image");
    out["pixels"] = frame_.pixels.size();
    out["differ"] = differ;
    out["differ_share"] =
        ratio(static_cast<double>(differ), static_cast<double>(frame_.pixels.size()));
    out["differ_by_10"] = found.beyond;
    if (std::isfinite(found.psnr) && differ > 0) out["psnr"] = found.psnr;
    out["rms"] = 255 * found.rms;
    out["mean"] = 255 * found.mean;
    out["largest"] = std::lround(255 * found.largest);
    return out.take();
  }

  const Truth& truth_;
  const TruthFrame& expected_;
  const Frame& frame_;
  const MatrixOwners& owners_;
  const NumberOf& number_;
  std::vector<bool> right_;  ///< of every pixel: its primary ray hit correctly
};

}  // namespace

std::span<const MeasureDefinition> measures() { return kMeasures; }

std::string measures_table() {
  std::string out = "| rays | measure | unit | better | meaning |\n|---|---|---|---|---|\n";
  for (const MeasureDefinition& m : kMeasures) {
    out +=
        fmt::format("| {} | `{}` | {} | {} | {} |\n", m.group, m.name, m.unit, m.better, m.meaning);
  }
  return out;
}

TruthShading shading_of(const CoreInfo& core, const FrameConfig& frame) {
  TruthShading out;
  out.width = static_cast<unsigned>(frame.width.raw());
  out.height = static_cast<unsigned>(frame.height.raw());
  out.eye_light = core.lights == 0 && core.reflections == 0;
  out.mirrors = core.reflections > 0;
  out.lights = static_cast<unsigned>(frame.lights.raw());
  out.reflections = static_cast<unsigned>(frame.reflections.raw());
  out.ambient = static_cast<unsigned>(frame.ambient.raw());
  out.background = static_cast<std::uint32_t>(frame.background.raw());
  return out;
}

ordered_json measure(const Truth& truth, const TruthFrame& expected, const Frame& frame,
                     const MatrixOwners& owners, const NumberOf& number) {
  return Judge(truth, expected, frame, owners, number).all();
}

std::vector<std::uint32_t> difference_picture(std::span<const std::uint32_t> expected,
                                              std::span<const std::uint32_t> pixels) {
  constexpr int kTimes = 16;
  std::vector<std::uint32_t> out(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int distance = std::abs(level(pixels[i], k) - level(expected[i], k));
      out[i] |= static_cast<std::uint32_t>(std::min(kTimes * distance, 255)) << (8 * k);
    }
  }
  return out;
}

}  // namespace dynrt::host
