// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/counts/counts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

#include "host/analysis/counts/packet_tracer.h"

namespace dynrt::host {

std::uint64_t WorkCounts::bound() const {
  return std::max({steps() + leaf_fetches, 5 * (triangles + objects + packets), list_entries});
}

void WorkCounts::add(const WorkCounts& more) {
  packets += more.packets;
  top_steps += more.top_steps;
  object_steps += more.object_steps;
  leaf_fetches += more.leaf_fetches;
  empty_leaves += more.empty_leaves;
  list_entries += more.list_entries;
  triangles += more.triangles;
  objects += more.objects;
  hits += more.hits;
  dropped_pushes += more.dropped_pushes;
  deepest_stack = std::max(deepest_stack, more.deepest_stack);
}

namespace {

template <int kRays>
WorkCounts trace(const TracedScene& scene, unsigned width, unsigned height,
                 std::span<TracedHit> hits) {
  constexpr unsigned kSide = PacketTracer<kRays>::kSide;
  const auto add = [](WorkCounts left, const WorkCounts& right) {
    left.add(right);
    return left;
  };
  return tbb::parallel_reduce(
      tbb::blocked_range<unsigned>(0, height / kSide), WorkCounts{},
      [&](const tbb::blocked_range<unsigned>& range, const WorkCounts& before) {
        PacketTracer<kRays> tracer(scene, hits);
        for (unsigned row = range.begin(); row != range.end(); ++row) {
          tracer.rows(row * kSide, width, height);
        }
        return add(before, tracer.work());
      },
      add);
}

}  // namespace

TracedFrame trace_frame(const Scene& scene, std::span<const Tree> objects, const TopLevel& top,
                        const Camera& camera, unsigned width, unsigned height,
                        const TraceOptions& options) {
  const TracedScene traced(scene, objects, top, camera, options);
  TracedFrame frame;
  frame.hits.resize(std::size_t{width} * height);
  frame.work = options.single_rays ? trace<1>(traced, width, height, frame.hits)
                                   : trace<4>(traced, width, height, frame.hits);
  return frame;
}

TracedFrame trace_frame(const Scene& scene, const SceneTrees& trees, const Camera& camera,
                        unsigned width, unsigned height, const TraceOptions& options) {
  return trace_frame(scene, trees.objects, {trees.instances, {}}, camera, width, height, options);
}

}  // namespace dynrt::host
