// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// How fast the truth is, in rays a second of all processors: primary rays of the scene `office`.
#include <benchmark/benchmark.h>

#include <vector>

#include "host/scene/camera.h"
#include "host/scene/load.h"
#include "host/truth/rays.h"
#include "host/truth/truth.h"

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
  const auto traced = static_cast<double>(truth.counts().rays);
  state.counters["rays"] = benchmark::Counter(traced, benchmark::Counter::kIsRate);
  state.counters["tests_per_ray"] = static_cast<double>(truth.counts().primitives) / traced;
  state.counters["exact_per_ray"] = static_cast<double>(truth.counts().exact) / traced;
}
BENCHMARK(primary_rays)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace dynrt::host
