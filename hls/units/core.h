// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core: every unit once, and how they are joined (thesis figures 6.1 and 7.3). The native
// model, the Verilog top and the block diagram all come from this constructor. A packet is in one
// place at a time, so a channel that holds all packets can never be the end of a deadlock. Nor can
// one whose reader writes into such channels alone: it empties whatever the others do, so that
// short FIFOs do for its writers.
#pragma once

#include <memory>

#include "hls/join.h"
#include "units/box_clip.h"
#include "units/cache_fill.h"
#include "units/cache_lookup.h"
#include "units/camera_rays.h"
#include "units/collect_hits.h"
#include "units/intersection.h"
#include "units/light_columns.h"
#include "units/list.h"
#include "units/mailbox.h"
#include "units/matrix_fetch.h"
#include "units/matrix_store.h"
#include "units/memory_interface.h"
#include "units/node_fetch.h"
#include "units/packet_decision.h"
#include "units/packet_decoder.h"
#include "units/plane_offset.h"
#include "units/ray_generation.h"
#include "units/ray_reciprocal.h"
#include "units/ray_shear.h"
#include "units/secondary_rays.h"
#include "units/send_packet.h"
#include "units/shader.h"
#include "units/shading.h"
#include "units/startup.h"
#include "units/transformation.h"
#include "units/traversal_slice.h"
#include "units/unit_decoder.h"

namespace dynrt {

/// The board's six memory banks, as the core sees them: those of the scene, and those that it
/// writes.
template <class C>
struct Banks {
  template <class W>
  using Bank = hls::Rows<W>;
  std::array<Bank<SceneWord<typename C::Real>>, kSceneBanks> scene;
  std::array<Bank<Word>, kBanks - kFrameBank> out;
};

template <class C>
struct Core {
  Startup<C> startup;
  RayGeneration<C> ray_generation;
  NodeFetch<C> node_fetch;
  CacheLookup<C, NodeCache<C>> node_lookup;
  CacheFill<C, NodeCache<C>> node_fill;
  hls::OptionalPort<kCommonOrigin<C>, PlaneOffset<C>> plane_offset;
  TraversalSlice<C> slice[kRays<C>];
  PacketDecision<C> packet_decision;
  List<C> list;
  CacheLookup<C, ListCache<C>> list_lookup;
  CacheFill<C, ListCache<C>> list_fill;
  Mailbox<C> mailbox;
  MatrixFetch<C> matrix_fetch;
  CacheLookup<C, MatrixCache<C>> matrix_lookup;
  CacheFill<C, MatrixCache<C>> matrix_fill;
  MatrixStore<C> matrix_store;
  SendPacket<C> send_packet;
  Transformation<C> transformation;
  hls::OptionalPort<kOwnCamera<C>, CameraRays<C>> camera_rays;
  hls::OptionalPort<kOwnCamera<C>, UnitDecoder<C>> unit_decoder;
  PacketDecoder<C> packet_decoder;
  hls::OptionalPort<kHasReciprocals<C>, RayReciprocal<C>> ray_reciprocal;
  hls::OptionalPort<kClipsToBox<C>, BoxClip<C>> box_clip;
  hls::OptionalPort<kWatertight<C>, RayShear<C>> ray_shear;
  Intersection<C> intersection;
  CollectHits<C> collect_hits;
  Shading<C> shading;
  hls::OptionalPort<kHasSecondary<C>, Shader<C>> shader;
  hls::OptionalPort<kHasSecondary<C>, SecondaryRays<C>> secondary_rays;
  hls::OptionalPort<kHasLights<C>, LightColumns<C>> light_columns;
  MemoryInterface<C> memory_interface;

  std::shared_ptr<hls::Fifo<uint<10>>> start;
  std::shared_ptr<hls::Fifo<uint<1>>> done;
  std::shared_ptr<FrameRegisters<C>> frame = std::make_shared<FrameRegisters<C>>();

  Core(hls::Join& join, const Banks<C>& banks) {
    name_units(join);
    join_frame(join);
    join_traversal(join);
    join_lists(join);
    join_transformation(join);
    if constexpr (kHasSecondary<C>) join_secondary(join);
    join_memory(join, banks);
    if constexpr (!C::kCounters) join.leave_out_counters();
  }

  static_assert(C::kPackets <= kResetClocks, "the reset before a frame clears no more rows");
  static_assert(C::kLines <= kFirstPacket, "start tokens have no numbers for more lines");

  /// Joins nothing yet: for tools that only list the units.
  Core() = default;

  /// Calls join.unit(name, module, unit) for every unit of configuration C, group by group. This is
  /// the only list of units: a unit that is not in it is neither joined nor lowered.
  template <class J>
  void name_units(J& join) {
    join.group("Ray generation and shading");
    join.unit("startup", "startup", startup);
    join.unit("ray_generation", "ray_generation", ray_generation);
    join.group("Traversal");
    join.unit("node_fetch", "node_fetch", node_fetch);
    join.unit("node_lookup", "node_lookup", node_lookup);
    join.unit("node_fill", "node_fill", node_fill);
    if constexpr (kCommonOrigin<C>) join.unit("plane_offset", "plane_offset", plane_offset);
    for (unsigned i = 0; i < kRays<C>; ++i) {
      join.unit("slice_" + std::to_string(i), "traversal_slice", slice[i]);
    }
    join.unit("packet_decision", "packet_decision", packet_decision);
    join.group("Lists");
    join.unit("list", "list", list);
    join.unit("list_lookup", "list_lookup", list_lookup);
    join.unit("list_fill", "list_fill", list_fill);
    join.unit("mailbox", "packet_mailbox", mailbox);
    join.group("Transformation");
    join.unit("matrix_fetch", "matrix_fetch", matrix_fetch);
    join.unit("matrix_lookup", "matrix_lookup", matrix_lookup);
    join.unit("matrix_fill", "matrix_fill", matrix_fill);
    join.unit("matrix_store", "matrix_store", matrix_store);
    join.unit("send_packet", "send_packet", send_packet);
    join.unit("transformation", "transformation", transformation);
    if constexpr (kOwnCamera<C>) {
      join.unit("camera_rays", "camera_rays", camera_rays);
      join.unit("unit_decoder", "unit_decoder", unit_decoder);
    }
    join.unit("packet_decoder", "packet_decoder", packet_decoder);
    if constexpr (kHasReciprocals<C>) {
      join.unit("ray_reciprocal", "ray_reciprocal", ray_reciprocal);
    }
    if constexpr (kClipsToBox<C>) join.unit("box_clip", "box_clip", box_clip);
    if constexpr (kWatertight<C>) join.unit("ray_shear", "ray_shear", ray_shear);
    join.group("Intersection");
    join.unit("intersection", "intersection", intersection);
    join.unit("collect_hits", "collect_hits", collect_hits);
    join.group("Ray generation and shading");
    join.unit("shading", "shading", shading);
    join.group("Memory");
    join.unit("memory_interface", "memory_interface", memory_interface);
    join.group("Light and reflection rays");
    if constexpr (kHasSecondary<C>) {
      join.unit("shader", "shader", shader);
      join.unit("secondary_rays", "secondary_rays", secondary_rays);
    }
    if constexpr (kHasLights<C>) join.unit("light_columns", "light_columns", light_columns);
  }

 private:
  static constexpr unsigned kAll = C::kPackets;  ///< tokens that a channel of packets can hold
  static constexpr auto kShort = hls::WriterFifos::kShort;

  void join_frame(hls::Join& join) {
    std::vector<hls::Config<FrameRegisters<C>>*> readers = {
        &ray_generation.frame, &node_lookup.frame, &node_fill.frame,
        &list_lookup.frame,    &list_fill.frame,   &matrix_lookup.frame,
        &matrix_fill.frame,    &mailbox.frame,     &shading.frame};
    if constexpr (C::kUncompressed) {
      readers.push_back(&matrix_store.frame);
      if constexpr (kOwnCamera<C>) readers.push_back(&camera_rays.frame);
    }
    if constexpr (kMainFirst<C>) readers.push_back(&node_fetch.frame);
    if constexpr (kHasSecondary<C>) {
      readers.insert(readers.end(), {&shader.frame, &secondary_rays.frame});
    }
    join.config<FrameRegisters<C>>("frame", frame, readers);
    start = join.input("start", startup.number);
    done = join.output("done", ray_generation.done);
    join.channel<FreePacket<C>>("free_packet",
                                {&startup.free, &ray_generation.skipped, &shading.free},
                                {&ray_generation.free}, kAll);
    join.ram("pixel_position", ray_generation.position,
             std::array{&pixel_reader().position, &shading.position});
    if constexpr (kHasSecondary<C>) {
      join.repeat("shade_job", hls::Writers{&node_fetch.top_done}, shader.job, kAll);
      join.repeat("write_job", hls::Writers{&secondary_rays.finished}, shading.job, kAll);
    } else {
      join.repeat("shade_job", hls::Writers{&node_fetch.top_done}, shading.job, kAll);
    }
    join.ram("hit_record", collect_hits.hit, std::array{&shading.hit});
  }

  auto& pixel_reader() {
    if constexpr (kOwnCamera<C>) {
      return camera_rays;
    } else {
      return send_packet;
    }
  }

  void join_traversal(hls::Join& join) {
    hls::Writers<TraversalEvent<C>> events = {&packet_decision.event, &node_fetch.again,
                                              &list.finished, &mailbox.start};
    if constexpr (kClipsToBox<C>) {
      events.push_back(&box_clip.enter_object);
    } else if constexpr (kTwoLevels<C> && kHasReciprocals<C>) {
      events.push_back(&ray_reciprocal.enter_object);
    } else if constexpr (kWatertight<C>) {
      events.push_back(&ray_shear.enter_object);
    } else if constexpr (kTwoLevels<C>) {
      events.push_back(&packet_decoder.enter_object);
    }
    join.channel<TraversalEvent<C>>("traversal_event", events, {&node_fetch.event}, kAll);
    join.channel("node_request", node_fetch.request, node_lookup.request, kAll);
    hls::Readers<Step<C>> steps = {};
    for (TraversalSlice<C>& one : slice) steps.push_back(&one.step_in);
    steps.push_back(&packet_decision.step_in);
    const hls::Writers<Step<C>> nodes = {&node_lookup.reply, &node_fill.reply};
    if constexpr (kCommonOrigin<C>) {
      join.channel<Step<C>>("step", nodes, {&plane_offset.step_in});
      join.channel<Step<C>>("offset", {&plane_offset.offset}, steps, kAll, kShort);
      join.ram("origin", origins_written(), std::array{&plane_offset.origin});
    } else {
      join.channel<Step<C>>("step", nodes, steps, kAll, kShort);
    }
    for (unsigned i = 0; i < kRays<C>; ++i) {
      join.constant(slice[i].lane, RayIndex<C>::from(i));
      join.channel("decision_" + std::to_string(i), slice[i].decision, packet_decision.slice[i],
                   kAll);
      join_rays(join, i);
      join.ram("distance_" + std::to_string(i), collect_hits.distance[i], distance_readers(i));
      if constexpr (kSplitsPackets<C>) {
        join.ram("signs_" + std::to_string(i), packet_decoder.signs[i],
                 std::array{&node_fetch.signs[i]});
      }
    }
    join.sink("stack_full", node_fetch.dropped);
  }

  /// The rays that a slice reads.
  void join_rays(hls::Join& join, unsigned i) {
    const std::string name = "ray_" + std::to_string(i);
    if constexpr (kReadsAxes<C>) {
      join.ram_of_words(name, rays_written(i), std::array{&slice[i].ray});
    } else {
      join.ram(name, rays_written(i), std::array{&slice[i].ray});
    }
  }
  auto& rays_written(unsigned i) {
    if constexpr (kHasReciprocals<C>) {
      return ray_reciprocal.ray[i];
    } else {
      return packet_decoder.ray[i];
    }
  }

  auto& origins_written() {
    if constexpr (kHasReciprocals<C>) {
      return ray_reciprocal.origin;
    } else {
      return packet_decoder.origin;
    }
  }

  void join_lists(hls::Join& join) {
    hls::Writers<ListJob<C>> jobs = {&packet_decision.leaf};
    if constexpr (kTwoLevels<C>) jobs.push_back(&node_fetch.object_done);
    if constexpr (Mailbox<C>::kHasObjects || Mailbox<C>::kHasTriangles) {
      jobs.push_back(&mailbox.seen);
    }
    jobs.push_back(&collect_hits.go_on);
    if constexpr (kClipsToBox<C>) jobs.push_back(&box_clip.missed);
    join.channel<ListJob<C>>("list_job", jobs, {&list.job}, kAll);
    join.channel("list_request", list.request, list_lookup.request, kAll);
    join.channel<MailboxEntry<C>>("list_entry", list_entries(), {&mailbox.entry});
    join.ram("last_entry", mailbox.last, std::array{&list.last});
    if constexpr (kPointsToLists<C>) {
      join.ram("after_leaf", packet_decision.after, std::array{&list.after});
    }
  }

  void join_transformation(hls::Join& join) {
    hls::Writers<TransformJob<C>> jobs = {&mailbox.fresh, &ray_generation.job};
    if constexpr (kHasSecondary<C>) jobs.push_back(&secondary_rays.job);
    join.repeat("transform_job", jobs, matrix_fetch.job, kAll);
    join.channel("column_request", matrix_fetch.request, matrix_lookup.request);
    using Column = typename MatrixCache<C>::Reply;
    if constexpr (kHasLights<C>) {
      join.channel<Column>("matrix_column", {&matrix_lookup.reply, &matrix_fill.reply},
                           {&light_columns.fetched});
      join.channel("stored_column", light_columns.column, matrix_store.reply);
    } else {
      join.channel<Column>("matrix_column", {&matrix_lookup.reply, &matrix_fill.reply},
                           {&matrix_store.reply});
    }
    for (unsigned c = 0; c < 4; ++c) {
      std::vector readers = {&transformation.column[c]};
      if constexpr (kOwnCamera<C>) readers.push_back(&camera_rays.column[c]);
      join.ram("column_" + std::to_string(c), matrix_store.column[c], readers);
    }
    std::vector records = {&packet_decoder.record, &collect_hits.record};
    if constexpr (kOwnCamera<C> && kMarksUnitRays<C>) records.push_back(&unit_decoder.record);
    join.ram("job_record", matrix_store.record, records);
    if constexpr (kTwoLevels<C>) {
      join.ram("object", matrix_store.object, std::array{&collect_hits.object});
    }
    join.repeat("send_job", hls::Writers{&matrix_store.ready}, send_packet.job, kAll);
    std::vector vectors = {&send_packet.vectors};
    if constexpr (kHasLights<C>) vectors.push_back(&shader.vectors);
    join.ram("ray_vectors", packet_decoder.vectors, vectors);
    join.channel("packet_vector", send_packet.vector, transformation.vector);
    hls::Writers<PacketVector<C>> rays = {&transformation.transformed};
    hls::Writers<UnitRay<C>> unit_rays = {};
    if constexpr (kOwnCamera<C>) {
      join.repeat("camera_job", hls::Writers{&matrix_store.camera}, camera_rays.job, kAll);
      rays.push_back(&camera_rays.vector);
      join.channel("in_unit_space", transformation.in_unit_space, unit_decoder.vector);
      unit_rays.push_back(&unit_decoder.unit_ray);
    }
    join.channel<PacketVector<C>>("transformed", rays, {&packet_decoder.vector});
    if constexpr (kDecodesUnitRays<C>) unit_rays.push_back(&packet_decoder.unit_ray);
    if constexpr (kHasReciprocals<C>) {
      if constexpr (kInvertsAtOnce<C>) {
        join.channel("traced_ray", packet_decoder.traced, ray_reciprocal.traced);
      } else {
        // A ray comes with each clock and takes three; the transformation must not wait for them.
        join.repeat("traced_ray", hls::Writers{&packet_decoder.traced}, ray_reciprocal.traced,
                    kRays<C> * kAll);
      }
      unit_rays.push_back(&ray_reciprocal.reset);
    }
    if constexpr (kClipsToBox<C>) {
      if constexpr (kHasReciprocals<C>) {
        join.channel("object_ray", ray_reciprocal.object_ray, box_clip.ray);
      } else {
        join.channel("object_ray", packet_decoder.object_ray, box_clip.ray);
      }
      for (unsigned i = 0; i < kRays<C>; ++i) {
        join.ram("box_" + std::to_string(i), box_clip.interval[i], std::array{&slice[i].box});
      }
    }
    if constexpr (kWatertight<C>) {
      join.channel("object_ray", packet_decoder.object_ray, ray_shear.ray);
      join.ram("ray_map", ray_shear.map, std::array{&transformation.map});
    }
    join.channel<UnitRay<C>>("unit_ray", unit_rays, {&intersection.unit_ray});
    join.channel("candidate", intersection.candidate, collect_hits.candidate);
  }

  /// Light and reflection rays (thesis 6.2).
  void join_secondary(hls::Join& join) {
    hls::Writers<DerivationEvent<C>> derive = {&shader.derive, &collect_hits.derived};
    std::vector surface = {&secondary_rays.surface, &collect_hits.surface};
    std::vector<hls::RamRead<Ray<typename C::Real>, kRayRows<C>>*> arriving;
    if constexpr (kHasLights<C>) {
      arriving.push_back(&light_columns.arriving);
      surface.push_back(&send_packet.surface);
      join.ram("light", light_columns.light, std::array{&shader.light});
    }
    if constexpr (kHasMirrors<C>) {
      if constexpr (kTwoLevels<C>) derive.push_back(&packet_decoder.derived);
      arriving.push_back(&send_packet.arriving);
      for (unsigned i = 0; i < kRays<C>; ++i) {
        std::vector readers = {&slice[i].start_distance};
        if constexpr (kClipsToBox<C>) readers.push_back(&box_clip.start_distance[i]);
        join.ram("start_distance_" + std::to_string(i), collect_hits.start_distance[i], readers);
      }
    }
    join.channel<DerivationEvent<C>>("derive", derive, {&secondary_rays.derive}, kAll);
    join.ram("arriving_ray", packet_decoder.arriving, arriving);
    join.ram("surface_point", shader.surface, surface);
    join.ram("traced", secondary_rays.traced, std::array{&shader.traced});
    join.ram("found", collect_hits.found, std::array{&shader.found});
    join.ram("pixel_colour", shader.pixel_colour, std::array{&shading.pixel_colour});
  }

  /// The units that need the distance of a ray's hit.
  auto distance_readers(unsigned i) {
    std::vector readers = {&slice[i].hit_distance};
    if constexpr (kClipsToBox<C>) readers.push_back(&box_clip.hit_distance[i]);
    return readers;
  }

  /// The inputs of the mailbox.
  hls::Writers<MailboxEntry<C>> list_entries() {
    hls::Writers<MailboxEntry<C>> entries = {&list_lookup.reply, &list_fill.reply,
                                             &collect_hits.start};
    if constexpr (kHasSecondary<C>) entries.push_back(&secondary_rays.start);
    return entries;
  }

  void join_memory(hls::Join& join, const Banks<C>& banks) {
    join.channel<MemoryRequest<C>>("memory_request",
                                   {&node_lookup.miss, &list_lookup.miss, &matrix_lookup.miss},
                                   {&memory_interface.request});
    join.channel<NodeLine<C>>("node_line", {&memory_interface.node, &startup.node},
                              {&node_fill.fill});
    join.channel<ListLine<C>>("list_line", {&memory_interface.list, &startup.list},
                              {&list_fill.fill});
    join.channel<ColumnLine<C>>("column_line", {&memory_interface.column, &startup.column},
                                {&matrix_fill.fill});
    join_cache(join, "node", node_lookup, node_fill);
    join_cache(join, "list", list_lookup, list_fill);
    join_cache(join, "matrix", matrix_lookup, matrix_fill);
    for (unsigned i = 0; i < kSceneBanks; ++i) {
      join.bank("bank" + std::to_string(i), memory_interface.bank[i], banks.scene[i]);
    }
    for (unsigned i = 0; i < banks.out.size(); ++i) {
      join.bank("bank" + std::to_string(kFrameBank + i), shading.bank[i], banks.out[i]);
    }
    // The misses of a cache depend on the order of the packets, and so do the fetches that follow.
    join.depends_on_order({"memory_request", "memory_interface", "node_line", "node_fill",
                           "list_line", "list_fill", "column_line", "matrix_fill"});
  }

  template <class Lookup, class Fill>
  static void join_cache(hls::Join& join, const std::string& name, Lookup& lookup, Fill& fill) {
    join.ram<hls::Hazard::kTorn>(name + "_lines", fill.lines, std::array{&lookup.lines});
    join.ram(name + "_waiting", lookup.waiting, std::array{&fill.waiting});
  }
};

}  // namespace dynrt
