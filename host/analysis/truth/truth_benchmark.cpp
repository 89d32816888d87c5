// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// How fast the truth is: all primary rays of the scene `office`, on all processors.
#include <benchmark/benchmark.h>

#include <vector>

#include "host/analysis/truth/rays.h"
#include "host/analysis/truth/truth.h"
#include "host/scene/camera.h"
#include "host/scene/load.h"

namespace dynrt::host {
namespace {

constexpr unsigned kWidth = 512;
constexpr unsigned kHeight = 384;

void primary_rays(benchmark::State& state) {
  const Scene scene = load_scene("office");
  const Camera camera = choose_camera(scene, {}, kWidth, kHeight);
  const Truth truth(scene);
  std::vector<TruthRay> rays;
  for (unsigned y = 0; y < kHeight; ++y) {
    for (unsigned x = 0; x < kWidth; ++x) {
      rays.push_back(primary_ray(camera, kWidth, kHeight, x, y));
    }
  }
  for (auto _ : state) benchmark::DoNotOptimize(truth.nearest(rays));
  const TruthCounts counts = truth.counts();
  const auto traced = static_cast<double>(counts.rays);
  state.counters["rays"] = static_cast<double>(rays.size());
  state.counters["tests_per_ray"] = static_cast<double>(counts.primitives) / traced;
  state.counters["exact_per_ray"] = static_cast<double>(counts.exact) / traced;
}
BENCHMARK(primary_rays)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace dynrt::host
