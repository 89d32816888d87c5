// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The clock of a Verilated primitive, and the traffic that its tests send.
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>

#include <random>

namespace dynrt::rtl {

inline constexpr unsigned kClocks = 20000;

template <class V>
void settle(V& v) {
  v.clk_i = 0;
  v.eval();
}
template <class V>
void clock(V& v) {
  v.clk_i = 1;
  v.eval();
}
template <class V>
void reset(V& v) {
  v.rst_ni = 0;
  for (int i = 0; i < 3; ++i) settle(v), clock(v);
  v.rst_ni = 1;
}

/// 1 in `n`, changing between often and seldom, so that queues run full and empty.
inline bool chance(std::mt19937& random, unsigned t, unsigned phase) {
  return random() % ((t / 500 + phase) % 2 == 0 ? 4u : 1u) == 0;
}

}  // namespace dynrt::rtl
