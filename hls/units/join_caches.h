// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins of the two halves of each cache: a RAM of lines for each way, the requests that wait,
// and the use of sets, which the lookup keeps for itself.
#pragma once

#include "units/pipeline.h"

namespace dynrt {

template <class C>
void Pipeline<C>::join_caches(hls::Join& join) {
  join_cache(join, "node", node_lookup, node_fill);
  join_cache(join, "list", list_lookup, list_fill);
  join_cache(join, "matrix", matrix_lookup, matrix_fill);
}

template <class C>
template <class Lookup, class Fill>
void Pipeline<C>::join_cache(hls::Join& join, const std::string& name, Lookup& lookup, Fill& fill) {
  for (unsigned i = 0; i < C::kWays; ++i) {
    const std::string way = kHasWays<C> ? "_" + std::to_string(i) : "";
    join.ram<hls::Hazard::kTorn>(name + "_lines" + way, port_of<C::kWays>(fill.lines, i),
                                 std::array{&port_of<C::kWays>(lookup.lines, i)});
  }
  join.ram(name + "_waiting", lookup.waiting, std::array{&fill.waiting});
  if constexpr (kHasWays<C>) {
    join.ram<hls::Hazard::kTorn>(name + "_use", lookup.used, std::array{&lookup.use});
  }
}

}  // namespace dynrt
