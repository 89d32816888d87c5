// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core: every unit once, and how they are joined (thesis figures 6.1 and 7.3). The native
// model, the Verilog top and the block diagram all come from this constructor. A packet is in one
// place at a time, so a channel that holds all packets can never be the end of a deadlock. Nor can
// one whose reader writes into such channels alone: it empties whatever the others do, so that
// short FIFOs do for its writers.
//
// `node_fetch` waits for no one, as its FIFOs hold all packets, and `list` for it alone, as
// list.request holds all. So the FIFOs of traversal events may be short, those of node_fetch aside,
// and of list jobs those of `packet_decision` and `mailbox`. On the loops of the transformation
// mailbox.fresh and matrix_store.box hold all, and other jobs for matrices may be short. So may the
// jobs of `matrix_store`, unless columns of lights come first. A test finds units in a circle.
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
#include "units/light_rays.h"
#include "units/list.h"
#include "units/mailbox.h"
#include "units/mailbox_of_rays.h"
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
#include "units/world_box.h"

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
  std::conditional_t<kSendsActive<C>, MailboxOfRays<C>, Mailbox<C>> mailbox;
  MatrixFetch<C> matrix_fetch;
  CacheLookup<C, MatrixCache<C>> matrix_lookup;
  CacheFill<C, MatrixCache<C>> matrix_fill;
  MatrixStore<C> matrix_store;
  SendPacket<C> send_packet;
  Transformation<C> transformation;
  hls::OptionalPort<kOwnCamera<C>, CameraRays<C>> camera_rays;
  hls::OptionalPort<kPairsUnitRays<C>, UnitDecoder<C>> unit_decoder;
  PacketDecoder<C> packet_decoder;
  hls::OptionalPort<kHasReciprocals<C>, RayReciprocal<C>> ray_reciprocal;
  hls::OptionalPort<kClipsToBox<C>, BoxClip<C>> box_clip;
  hls::OptionalPort<kTestsWorldBox<C>, WorldBox<C>> world_box;
  hls::OptionalPort<kMapsCorners<C>, RayShear<C>> ray_shear;
  Intersection<C> intersection;
  CollectHits<C> collect_hits;
  Shading<C> shading;
  hls::OptionalPort<kHasSecondary<C>, Shader<C>> shader;
  hls::OptionalPort<kHasSecondary<C>,
                    std::conditional_t<kLightsAtOnce<C>, LightRays<C>, SecondaryRays<C>>>
      secondary_rays;
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
    }
    if constexpr (kPairsUnitRays<C>) join.unit("unit_decoder", "unit_decoder", unit_decoder);
    join.unit("packet_decoder", "packet_decoder", packet_decoder);
    if constexpr (kHasReciprocals<C>) {
      join.unit("ray_reciprocal", "ray_reciprocal", ray_reciprocal);
    }
    if constexpr (kClipsToBox<C>) join.unit("box_clip", "box_clip", box_clip);
    if constexpr (kTestsWorldBox<C>) join.unit("world_box", "world_box", world_box);
    if constexpr (kMapsCorners<C>) join.unit("ray_shear", "ray_shear", ray_shear);
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
  static constexpr auto kShort = hls::WriterFifo::kShort;
  /// The FIFO of a writer whose reader always takes its tokens in the end (file comment).
  static constexpr auto kShortIfAsked =
      C::kPacketFifos == PacketFifos::kOne ? kShort : hls::WriterFifo::kHoldsAll;
  /// Steps that wait for the slices' decisions, of which a FIFO never holds more. A slice with
  /// reciprocals takes 8 clocks, FIFOs and buffers four; more would cost speed, not hits.
  static constexpr unsigned kSteps = kCommonOrigin<C> && kHasReciprocals<C> ? 16 : kAll;

  void join_frame(hls::Join& join) {
    std::vector<hls::Config<FrameRegisters<C>>*> readers = {
        &ray_generation.frame, &node_lookup.frame, &node_fill.frame,
        &list_lookup.frame,    &list_fill.frame,   &matrix_lookup.frame,
        &matrix_fill.frame,    &mailbox.frame,     &shading.frame};
    if constexpr (C::kUncompressed || kTestsWorldBox<C>) readers.push_back(&matrix_store.frame);
    if constexpr (C::kUncompressed && kOwnCamera<C>) readers.push_back(&camera_rays.frame);
    if constexpr (C::kUncompressed && kHasLights<C>) readers.push_back(&packet_decoder.frame);
    if constexpr (kTestsWorldBox<C>) readers.push_back(&matrix_fetch.frame);
    if constexpr (kMainFirst<C>) readers.push_back(&list.frame);
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

  void join_traversal(hls::Join& join);
  /// The rays that a slice reads.
  void join_rays(hls::Join& join, unsigned i);
  auto& rays_written(unsigned i);
  auto& origins_written();
  /// The units that need the distance of a ray's hit.
  auto distance_readers(unsigned i);
  void join_lists(hls::Join& join);
  /// The inputs of the mailbox.
  hls::Writers<MailboxEntry<C>> list_entries();
  void join_transformation(hls::Join& join);
  /// Light and reflection rays (thesis 6.2).
  void join_secondary(hls::Join& join);
  void join_memory(hls::Join& join, const Banks<C>& banks);
  template <class Lookup, class Fill>
  static void join_cache(hls::Join& join, const std::string& name, Lookup& lookup, Fill& fill);
};

}  // namespace dynrt

#include "units/join_memory.h"
#include "units/join_secondary.h"
#include "units/join_transformation.h"
#include "units/join_traversal.h"
