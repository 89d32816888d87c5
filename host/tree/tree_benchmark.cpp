// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// How long the trees take to build, on one core.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "host/tree/scene_trees.h"
#include "host/tree/test_meshes.h"

namespace dynrt::host {
namespace {

/// A room with about this many triangles.
void triangle_tree(benchmark::State& state) {
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const Mesh mesh = testing::room(1, static_cast<int>(state.range(0)) / 972, 16);
  for (auto _ : state) benchmark::DoNotOptimize(build_triangle_tree(mesh));
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}
BENCHMARK(triangle_tree)->Arg(34000)->Unit(benchmark::kMillisecond);

/// Turned and scaled boxes standing close on a plain, as trees in a wood.
void instance_tree(benchmark::State& state) {
  const auto count = static_cast<int>(state.range(0));
  Scene scene = testing::scene_of({});
  scene.instances.clear();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const double side = 2 * std::sqrt(count);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 at{unit(random) * side, unit(random) * unit(random) * 10, unit(random) * side};
    glm::dmat4 m = glm::rotate(glm::translate(glm::dmat4(1), at), 6 * unit(random), {0, 1, 0});
    m = glm::scale(m, glm::dvec3(0.5, 1, 0.5) + unit(random));
    scene.instances.push_back({"tree", 0, m});
  }
  const std::vector<Aabb> boxes{{glm::dvec3(-1), glm::dvec3(1)}};
  for (auto _ : state) benchmark::DoNotOptimize(build_instance_tree(scene, boxes));
}
BENCHMARK(instance_tree)->Arg(4000)->Arg(50000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dynrt::host
