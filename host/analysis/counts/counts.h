// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Counts the work that a scene's trees make: a tracer in doubles that walks packets of 2x2 primary
// rays through both levels as the core does (thesis 3.1.3, packet decision, termination, mailbox),
// only without rounding (packet_tracer.h). It measures the quality of trees, and its hits test the
// trees. It also counts variants that the core does not have, to show their cost or gain: rays one
// by one, other mailboxes, other clipping (4.2), other top levels (overlap.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/tree/scene_trees.h"

namespace dynrt::host {

struct WorkCounts {
  std::uint64_t packets = 0;
  std::uint64_t top_steps = 0;     ///< inner nodes fetched, of the instances' tree
  std::uint64_t object_steps = 0;  ///< inner nodes fetched, of objects' trees
  std::uint64_t leaf_fetches = 0;  ///< leaves fetched, which are never empty
  std::uint64_t empty_leaves = 0;  ///< empty children that were not fetched
  std::uint64_t list_entries = 0;
  std::uint64_t triangles = 0;       ///< packets transformed to a triangle, after the mailbox
  std::uint64_t objects = 0;         ///< packets transformed to an object, after the mailbox
  std::uint64_t hits = 0;            ///< rays
  std::uint64_t dropped_pushes = 0;  ///< for want of stack
  int deepest_stack = 0;

  std::uint64_t steps() const { return top_steps + object_steps; }
  /// Clocks of the busiest unit, with one step, one list entry and a fifth of a transformed packet
  /// a clock.
  std::uint64_t bound() const;
  void add(const WorkCounts& more);
};

struct TracedHit {
  bool hit = false;
  double t = 0, u = 0, v = 0;
  std::uint32_t instance = 0, triangle = 0;
};

/// Says which rays go through a tree's six clipping nodes.
enum class Clipping : std::uint8_t { kNever, kFromOutside, kAlways };

struct TraceOptions {
  bool single_rays = false;  ///< packets of one ray instead of 2x2
  int stack_depth = 31;
  unsigned object_slots = 8;  ///< of the mailbox, for each packet
  unsigned triangle_slots = 8;
  bool keeps_latest =
      false;  ///< full slots take the place of the oldest instead of staying as they are
  Clipping scene_clipping = Clipping::kFromOutside;
  Clipping object_clipping = Clipping::kFromOutside;
  bool object_clip_free = false;  ///< count the clipping nodes of objects as no steps
};

/// The structure that packets traverse in the world.
struct TopLevel {
  Tree tree;  ///< without nodes: nothing
  /// By node: the instances that a packet enters when it comes to the node. Empty: no node has any.
  std::vector<std::vector<std::uint32_t>> inner;
};

struct TracedFrame {
  WorkCounts work;
  std::vector<TracedHit> hits;  ///< row by row, as pixels are numbered
};

/// Traces width x height primary rays (even numbers), pixel centres at x + 1/2, on all cores. The
/// second form goes through the instances' tree alone.
TracedFrame trace_frame(const Scene& scene, std::span<const Tree> objects, const TopLevel& top,
                        const Camera& camera, unsigned width, unsigned height,
                        const TraceOptions& options);
TracedFrame trace_frame(const Scene& scene, const SceneTrees& trees, const Camera& camera,
                        unsigned width, unsigned height, const TraceOptions& options = {});

}  // namespace dynrt::host
