// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The counters of which the host makes figures. They are named after units and channels of the join
// (units/core.h); figures_test holds them against its description.
#pragma once

namespace dynrt::host::counters {

/// Pushes onto full stacks, which the core drops.
inline constexpr char kDroppedPushes[] = "stack_full.tokens";

/// Of a cache: the requests that it has answered, and the lines that it has taken.
struct OfCache {
  const char* cache;
  const char* lookups;
  const char* fills;
};
inline constexpr OfCache kCaches[] = {
    {"node", "node_lookup.transactions", "node_fill.transactions"},
    {"list", "list_lookup.transactions", "list_fill.transactions"},
    {"matrix", "matrix_lookup.transactions", "matrix_fill.transactions"},
};

}  // namespace dynrt::host::counters
