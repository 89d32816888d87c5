// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The counters of which the host makes figures. They are named after units and channels of the join
// (units/core.h); figures_test holds them against its description.
#pragma once

namespace dynrt::host::counters {

/// Pushes onto full stacks, which the core drops.
inline constexpr char kDroppedPushes[] = "stack_full.tokens";

/// Of a cache: the requests that it has answered, the lines that it has taken, and the words of the
/// scene's banks that a line takes.
struct OfCache {
  const char* cache;
  const char* lookups;
  const char* fills;
  unsigned words;
};
inline constexpr OfCache kCaches[] = {
    {"node", "node_lookup.transactions", "node_fill.transactions", 2},
    {"list", "list_lookup.transactions", "list_fill.transactions", 1},
    {"matrix", "matrix_lookup.transactions", "matrix_fill.transactions", 3},
};

/// Of the memory's port: beats that came, and lines for the caches, also from the second level.
inline constexpr char kBeats[] = "memory_gather.transactions";
inline constexpr char kPortLines[] = "memory_line.tokens";

}  // namespace dynrt::host::counters
