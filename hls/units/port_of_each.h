// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// N ports of a unit that do the same for N others: an array, or a port alone where N is 1, whose
// name then has no number.
#pragma once

#include <type_traits>

#include "hls/ports.h"

namespace dynrt {

template <unsigned N, class Port>
using PortOfEach = std::conditional_t<(N > 1), Port[N], Port>;

template <unsigned N, class Ports>
auto& port_of(Ports& ports, unsigned number) {
  if constexpr (N > 1) {
    return ports[number];
  } else {
    return ports;
  }
}

/// Writes to port `number`.
template <unsigned N, class Ports>
void write_to(Ports& ports, hls::uint<hls::index_width(N)> number, const auto&... data) {
  if constexpr (N > 1) {
    for (unsigned i = 0; i < N; ++i) {
      if (number == hls::uint<hls::index_width(N)>::from(i)) ports[i].write(data...);
    }
  } else {
    ports.write(data...);
  }
}

}  // namespace dynrt
