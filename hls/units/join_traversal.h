// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins of the traversal and of the lists in its leaves.
#pragma once

#include "units/pipeline.h"

namespace dynrt {

template <class C>
void Pipeline<C>::join_traversal(hls::Join& join) {
  hls::Writers<TraversalEvent<C>> events = {};
  events.push_back(&packet_decision.event, kShortInFast);
  events.push_back(&node_fetch.again);
  events.push_back(&list.finished, kShortInFast);
  events.push_back(&mailbox.start, kShortInFast);
  if constexpr (kTwoLevels<C> && kFast<C>) {
    events.push_back(&ray_reciprocal.enter_object, kShortInFast);
  } else if constexpr (kMapsCorners<C>) {
    events.push_back(&ray_shear.enter_object, kShortInFast);
  } else if constexpr (kTwoLevels<C>) {
    events.push_back(&packet_decoder.enter_object, kShortInFast);
  }
  join.channel<TraversalEvent<C>>("traversal_event", events, {&node_fetch.event}, kAll);
  join.channel("node_request", node_fetch.request, node_lookup.request, kAll);
  hls::Readers<Step<C>> steps = {};
  for (TraversalSlice<C>& one : slice) steps.push_back(&one.step_in);
  steps.push_back(&packet_decision.step_in);
  hls::Writers<Step<C>> nodes = {};
  nodes.push_back(&node_lookup.reply, kShort);
  nodes.push_back(&node_fill.reply, kShort);
  if constexpr (kCommonOrigin<C>) {
    join.channel<Step<C>>("step", nodes, {&plane_offset.step_in});
    join.channel<Step<C>>("offset", hls::Writers(&plane_offset.offset, kShort), steps, kSteps);
    std::vector origins = {&plane_offset.origin};
    if constexpr (kMapsBlocks<C>) origins.push_back(&matrix_store.origin);
    origins.push_back(&send_packet.origin);
    join.ram("origin", ray_reciprocal.origin, origins);
  } else {
    join.channel<Step<C>>("step", nodes, steps, kAll);
  }
  for (unsigned i = 0; i < kRays<C>; ++i) {
    join.constant(slice[i].lane, RayIndex<C>::from(i));
    join.channel("decision_" + std::to_string(i), slice[i].decision, packet_decision.slice[i],
                 kSteps);
    join_rays(join, i);
    join.ram("distance_" + std::to_string(i), collect_hits.distance[i],
             std::array{&slice[i].hit_distance});
    if constexpr (kSplitsPackets<C>) {
      join.ram("signs_" + std::to_string(i), packet_decoder.signs[i],
               std::array{&node_fetch.signs[i]});
    }
  }
  join.sink("stack_full", node_fetch.dropped);
}

template <class C>
void Pipeline<C>::join_rays(hls::Join& join, unsigned i) {
  const std::string name = "ray_" + std::to_string(i);
  if constexpr (kReadsAxes<C>) {
    join.ram_of_words(name, rays_written(i), std::array{&slice[i].ray});
  } else {
    join.ram(name, rays_written(i), std::array{&slice[i].ray});
  }
}

template <class C>
auto& Pipeline<C>::rays_written(unsigned i) {
  if constexpr (kFast<C>) {
    return ray_reciprocal.ray[i];
  } else {
    return packet_decoder.ray[i];
  }
}

template <class C>
void Pipeline<C>::join_lists(hls::Join& join) {
  hls::Writers<ListJob<C>> jobs = {};
  jobs.push_back(&packet_decision.leaf, kShortInFast);
  if constexpr (kTwoLevels<C>) jobs.push_back(&node_fetch.object_done);
  if constexpr (decltype(mailbox)::kAnswersLists) {
    jobs.push_back(&mailbox.seen, kShortInFast);
  }
  jobs.push_back(&collect_hits.go_on);
  if constexpr (kTestsWorldBox<C>) jobs.push_back(&world_box.missed);
  join.channel<ListJob<C>>("list_job", jobs, {&list.job}, kAll);
  join.channel("list_request", list.request, list_lookup.request, kAll);
  join.channel<MailboxEntry<C>>("list_entry", list_entries(), {&mailbox.entry});
  join.ram("last_entry", mailbox.last, std::array{&list.last});
  if constexpr (kFast<C>) {
    join.ram("after_leaf", packet_decision.after, std::array{&list.after});
  }
}

template <class C>
hls::Writers<MailboxEntry<C>> Pipeline<C>::list_entries() {
  hls::Writers<MailboxEntry<C>> entries = {&list_lookup.reply, &list_fill.reply,
                                           &collect_hits.start};
  if constexpr (kHasSecondary<C> && !kLightsAtOnce<C>) entries.push_back(&secondary_rays.start);
  return entries;
}

}  // namespace dynrt
