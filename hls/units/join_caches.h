// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins of the two halves of each cache.
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
  join.ram<hls::Hazard::kTorn>(name + "_lines", fill.lines, std::array{&lookup.lines});
  join.ram(name + "_waiting", lookup.waiting, std::array{&fill.waiting});
}

}  // namespace dynrt
