// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Time of one Float operation in the native model: independent operations over random pairs, and
// for sums a chain in which each needs the one before. Asked for: 10 ns or less on average.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <vector>

#include "hls/float.h"

namespace {

using Real = hls::Float<7, 16>;

/// Pairs of numbers about one, as rays and matrices have them, from a linear congruence.
std::vector<std::array<Real, 2>> pairs() {
  std::vector<std::array<Real, 2>> result(1000);
  std::uint64_t state = 1;
  const auto draw = [&state] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return Real::from_double(static_cast<double>(static_cast<std::int64_t>(state)) * 0x1p-60);
  };
  for (auto& pair : result) pair = {draw(), draw()};
  return result;
}

template <class Operation>
void independent(benchmark::State& state, Operation operation) {
  const auto operands = pairs();
  for (auto _ : state) {
    for (const auto& [a, b] : operands) benchmark::DoNotOptimize(operation(a, b));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(operands.size()));
}
BENCHMARK_CAPTURE(independent, add, [](Real a, Real b) { return a + b; });
BENCHMARK_CAPTURE(independent, subtract, [](Real a, Real b) { return a - b; });
BENCHMARK_CAPTURE(independent, multiply, [](Real a, Real b) { return a * b; });
BENCHMARK_CAPTURE(independent, divide, [](Real a, Real b) { return a / b; });
BENCHMARK_CAPTURE(independent, less, [](Real a, Real b) { return a < b; });

void chained_add(benchmark::State& state) {
  const auto operands = pairs();
  for (auto _ : state) {
    Real sum;
    for (const auto& pair : operands) sum = sum + pair[0];
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(operands.size()));
}
BENCHMARK(chained_add);

/// A point through a 3x4 matrix, 9 products and 9 sums each: the model's commonest work.
void transform(benchmark::State& state) {
  const auto operands = pairs();
  std::array<Real, 12> matrix;
  for (unsigned i = 0; i < matrix.size(); ++i) matrix[i] = operands[i][0];
  for (auto _ : state) {
    for (unsigned p = 0; p + 2 < operands.size(); ++p) {
      for (unsigned row = 0; row < 3; ++row) {
        const Real* m = &matrix[4 * row];
        benchmark::DoNotOptimize(
            ((m[0] * operands[p][1] + m[1] * operands[p + 1][1]) + m[2] * operands[p + 2][1]) +
            m[3]);
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(operands.size() - 2) * 18);
}
BENCHMARK(transform);

}  // namespace

BENCHMARK_MAIN();
