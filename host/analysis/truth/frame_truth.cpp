// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/truth/frame_truth.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/analysis/truth/rays.h"

namespace dynrt::host {

namespace {

constexpr unsigned kFull = 256;  ///< brightness
constexpr std::size_t kRaysPerTask = 256;

using Levels = std::array<unsigned, 3>;

/// Of |x|, up to one; rounded down.
unsigned in_256ths(double x) {
  return static_cast<unsigned>(std::min(std::floor(std::abs(x) * kFull), 1.0 * kFull));
}
unsigned times(unsigned a, unsigned b) { return a * b / kFull; }

Levels levels_of(const glm::dvec3& colour) {
  Levels out{};
  for (int k = 0; k < 3; ++k) {
    out[static_cast<std::size_t>(k)] =
        static_cast<unsigned>(std::lround(std::clamp(colour[k], 0.0, 1.0) * 255));
  }
  return out;
}
Levels levels_of(std::uint32_t pixel) {
  return {pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255};
}
std::uint32_t pixel_of(const Levels& levels) {
  return levels[0] | levels[1] << 8 | levels[2] << 16;
}

Sixteenths product(const Levels& colour, unsigned brightness) {
  Sixteenths out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = colour[k] * brightness / 16;
  return out;
}
void add(Sixteenths& sum, const Sixteenths& more) {
  for (std::size_t k = 0; k < 3; ++k) sum[k] += more[k];
}

/// A light's brightest channel, and its colour as parts of that.
struct Lamp {
  double intensity = 0;
  Levels colour{};
  explicit Lamp(const glm::dvec3& power) : intensity(std::max({power.x, power.y, power.z, 0.0})) {
    if (intensity > 0) colour = levels_of(power / intensity);
  }
  Levels on(const Levels& surface) const {
    Levels out{};
    for (std::size_t k = 0; k < 3; ++k) {
      out[k] = surface[k] * (colour[k] + (colour[k] >> 7)) / kFull;  // 255 of 255 is all of it
    }
    return out;
  }
};

template <class Body>
void in_parallel(std::size_t count, Body body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kRaysPerTask),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
                    });
}

/// Rays of one bounce, of those pixels that still have some.
struct Wave {
  std::vector<std::uint32_t> pixel;
  std::vector<unsigned> weight;  ///< share of the ray's light that reaches the eye, in 256ths
  std::vector<TruthRay> rays;
  std::vector<std::optional<TruthHit>> hits;
};

class Shading {
 public:
  Shading(const Truth& truth, TruthFrame& frame) : truth_(truth), frame_(frame) {
    for (unsigned i = 0; i < frame.shading.lights; ++i) {
      lamps_.emplace_back(truth.scene().lights.at(i).colour);
    }
  }

  void add_wave(const Wave& wave, unsigned bounce) {
    const TruthShading& shading = frame_.shading;
    for (std::size_t i = 0; i < wave.rays.size(); ++i) {
      Sixteenths& sum = frame_.unlimited[wave.pixel[i]];
      const auto& hit = wave.hits[i];
      if (!hit) {
        add(sum, product(levels_of(shading.background), wave.weight[i]));
        continue;
      }
      const unsigned bright = times(in_256ths(hit->cosine), shading.ambient);
      add(sum, product(colour_of(*hit), times(bright, diffuse(wave, i))));
    }
    for (unsigned light = 0; light < shading.lights; ++light) add_light(wave, bounce, light);
  }

  /// The rays that the mirrors of a wave reflect.
  Wave reflected(const Wave& wave) const {
    Wave out;
    for (std::size_t i = 0; i < wave.rays.size(); ++i) {
      const auto& hit = wave.hits[i];
      const unsigned mirror = hit ? mirror_of(*hit) : 0;
      if (mirror == 0) continue;
      out.pixel.push_back(wave.pixel[i]);
      out.weight.push_back(times(wave.weight[i], mirror));
      out.rays.push_back(reflection_ray(truth_.scene(), wave.rays[i], *hit).value());
    }
    return out;
  }

 private:
  const Material& material_of(const TruthHit& hit) const {
    const Scene& scene = truth_.scene();
    const Mesh& mesh = scene.objects[scene.instances[hit.id.instance].object];
    return scene.materials[mesh.material_of(hit.id.primitive)];
  }
  Levels colour_of(const TruthHit& hit) const { return levels_of(material_of(hit).diffuse); }
  /// The share of a mirror: neither none nor all of the light.
  unsigned mirror_of(const TruthHit& hit) const {
    const Scene& scene = truth_.scene();
    const Mesh& mesh = scene.objects[scene.instances[hit.id.instance].object];
    const double share = material_of(hit).mirror;
    if (!frame_.shading.mirrors || !(share > 0) || mesh.is_ellipsoid(hit.id.primitive)) return 0;
    return static_cast<unsigned>(std::clamp(std::lround(kFull * share), 1L, 255L));
  }
  unsigned diffuse(const Wave& wave, std::size_t i) const {
    return times(wave.weight[i], kFull - mirror_of(*wave.hits[i]));
  }

  void add_light(const Wave& wave, unsigned bounce, unsigned light) {
    const std::size_t first = frame_.light_rays.size();
    std::vector<std::size_t> of;  // in the wave
    for (std::size_t i = 0; i < wave.rays.size(); ++i) {
      if (!wave.hits[i]) continue;
      of.push_back(i);
      frame_.light_rays.push_back({wave.pixel[i], bounce, light, false, {}});
    }
    const PointLight& lamp = truth_.scene().lights[light];
    in_parallel(of.size(), [&](std::size_t k) {
      const std::size_t i = of[k];
      const TruthHit& hit = *wave.hits[i];
      const TruthRay ray = light_ray(truth_.scene(), lamp, wave.rays[i], hit);
      LightRayTruth& out = frame_.light_rays[first + k];
      out.shadow = truth_.any(ray);
      const auto surface = truth_.intersect(ray, hit.id);
      const double cosine = surface ? surface->cosine : 0;
      // Lit is the side that is seen.
      if (std::signbit(cosine) != std::signbit(hit.cosine)) return;
      const double square = glm::dot(ray.direction, ray.direction);
      const unsigned bright = in_256ths(lamps_[light].intensity * (cosine / square));
      out.adds = product(lamps_[light].on(colour_of(hit)), times(bright, diffuse(wave, i)));
    });
    for (std::size_t k = first; k < frame_.light_rays.size(); ++k) {
      const LightRayTruth& ray = frame_.light_rays[k];
      if (!ray.shadow) add(frame_.unlimited[ray.pixel], ray.adds);
    }
  }

  const Truth& truth_;
  TruthFrame& frame_;
  std::vector<Lamp> lamps_;
};

/// Shading that has nothing but the primary rays: one product, rounded once.
std::uint32_t eye_light(const Levels& colour, double cosine) {
  const unsigned bright = in_256ths(cosine);
  return pixel_of({times(colour[0], bright), times(colour[1], bright), times(colour[2], bright)});
}

}  // namespace

std::uint64_t TruthFrame::hit_count() const {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(hits, [](const auto& hit) { return hit.has_value(); }));
}

TruthFrame truth_of_frame(const Truth& truth, const Camera& camera, const TruthShading& shading) {
  const auto begin = std::chrono::steady_clock::now();
  TruthFrame frame;
  frame.shading = shading;
  Wave wave;
  for (unsigned y = 0; y < shading.height; ++y) {
    for (unsigned x = 0; x < shading.width; ++x) {
      wave.pixel.push_back(static_cast<std::uint32_t>(wave.pixel.size()));
      wave.rays.push_back(primary_ray(camera, shading.width, shading.height, x, y));
    }
  }
  wave.weight.assign(wave.rays.size(), kFull);
  wave.hits = truth.nearest(wave.rays);
  frame.rays = wave.rays;
  frame.hits = wave.hits;
  frame.unlimited.resize(wave.rays.size());
  frame.pixels.resize(wave.rays.size());

  Shading shader(truth, frame);
  if (shading.eye_light) {
    const Scene& scene = truth.scene();
    for (std::size_t i = 0; i < frame.hits.size(); ++i) {
      frame.pixels[i] = shading.background;
      if (const auto& hit = frame.hits[i]) {
        const Mesh& mesh = scene.objects[scene.instances[hit->id.instance].object];
        const Material& material = scene.materials[mesh.material_of(hit->id.primitive)];
        frame.pixels[i] = eye_light(levels_of(material.diffuse), hit->cosine);
      }
    }
  } else {
    shader.add_wave(wave, 0);
    for (unsigned bounce = 1; bounce <= shading.reflections; ++bounce) {
      wave = shader.reflected(wave);
      wave.hits = truth.nearest(wave.rays);
      for (std::size_t i = 0; i < wave.rays.size(); ++i) {
        frame.reflections.push_back({wave.pixel[i], bounce, wave.hits[i]});
      }
      shader.add_wave(wave, bounce);
    }
    // The shader cuts every sum off at white, which is the same in the end.
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
      Levels levels = frame.unlimited[i];
      for (unsigned& level : levels) level = std::min(level / 16, 255u);
      frame.pixels[i] = pixel_of(levels);
    }
  }
  frame.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return frame;
}

}  // namespace dynrt::host
