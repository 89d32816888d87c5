// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A ray tracing pipeline: what traces packets, and how it is joined (thesis figures 6.1 and 7.3). A
// packet is in one place at a time, so a channel that holds all packets can never be the end of a
// deadlock. Nor can one whose reader writes into such channels alone: it empties whatever the
// others do, so that short FIFOs do for its writers.
//
// `node_fetch` waits for no one, as its FIFOs hold all packets, and `list` for it alone, as
// list.request holds all. So the FIFOs of traversal events may be short, those of node_fetch aside,
// and of list jobs those of `packet_decision` and `mailbox`. On the loops of the transformation
// mailbox.fresh and matrix_store.box hold all, and other jobs for matrices may be short. So may the
// jobs of `matrix_store`, unless columns of lights come first. A test finds units in a circle.
#pragma once

#include <string>
#include <vector>

#include "hls/join.h"
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
#include "units/node_fetch.h"
#include "units/packet_decision.h"
#include "units/packet_decoder.h"
#include "units/plane_offset.h"
#include "units/ray_reciprocal.h"
#include "units/ray_shear.h"
#include "units/secondary_rays.h"
#include "units/send_packet.h"
#include "units/shader.h"
#include "units/shading.h"
#include "units/transformation.h"
#include "units/traversal_slice.h"
#include "units/unit_decoder.h"
#include "units/world_box.h"

namespace dynrt {

template <class C>
struct Pipeline {
  NodeFetch<C> node_fetch;
  CacheLookup<C, NodeCache<C>> node_lookup;
  CacheFill<C, NodeCache<C>> node_fill;
  hls::OptionalPort<kCommonOrigin<C>, PlaneOffset<C>> plane_offset;
  TraversalSlice<C> slice[kRays<C>];
  PacketDecision<C> packet_decision;
  List<C> list;
  CacheLookup<C, ListCache<C>> list_lookup;
  CacheFill<C, ListCache<C>> list_fill;
  std::conditional_t<kFast<C>, MailboxOfRays<C>, Mailbox<C>> mailbox;
  MatrixFetch<C> matrix_fetch;
  CacheLookup<C, MatrixCache<C>> matrix_lookup;
  CacheFill<C, MatrixCache<C>> matrix_fill;
  MatrixStore<C> matrix_store;
  SendPacket<C> send_packet;
  Transformation<C> transformation;
  hls::OptionalPort<kFast<C>, CameraRays<C>> camera_rays;
  hls::OptionalPort<kPairsUnitRays<C>, UnitDecoder<C>> unit_decoder;
  PacketDecoder<C> packet_decoder;
  hls::OptionalPort<kFast<C>, RayReciprocal<C>> ray_reciprocal;
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

  /// Calls join.unit(name, module, unit) for every unit of configuration C, group by group.
  template <class J>
  void name_units(J& join) {
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
    if constexpr (kFast<C>) join.unit("camera_rays", "camera_rays", camera_rays);
    if constexpr (kPairsUnitRays<C>) join.unit("unit_decoder", "unit_decoder", unit_decoder);
    join.unit("packet_decoder", "packet_decoder", packet_decoder);
    if constexpr (kFast<C>) join.unit("ray_reciprocal", "ray_reciprocal", ray_reciprocal);
    if constexpr (kTestsWorldBox<C>) join.unit("world_box", "world_box", world_box);
    if constexpr (kMapsCorners<C>) join.unit("ray_shear", "ray_shear", ray_shear);
    join.group("Intersection");
    join.unit("intersection", "intersection", intersection);
    join.unit("collect_hits", "collect_hits", collect_hits);
    join.group("Ray generation and shading");
    join.unit("shading", "shading", shading);
  }
  template <class J>
  void name_secondary(J& join) {
    join.group("Light and reflection rays");
    if constexpr (kHasSecondary<C>) {
      join.unit("shader", "shader", shader);
      join.unit("secondary_rays", "secondary_rays", secondary_rays);
    }
    if constexpr (kHasLights<C>) join.unit("light_columns", "light_columns", light_columns);
  }

  /// The units that read the registers of the frame.
  std::vector<hls::Config<FrameRegisters<C>>*> frame_readers();
  /// The pixels of packets and their jobs, from a packet's rays to its hits' shading.
  void join_shading(hls::Join& join, PixelPositions<C>& position);
  void join_traversal(hls::Join& join);
  void join_lists(hls::Join& join);
  /// `camera` writes the jobs of new packets.
  void join_transformation(hls::Join& join, hls::Out<TransformJob<C>>& camera);
  /// Light and reflection rays (thesis 6.2).
  void join_secondary(hls::Join& join);
  void join_caches(hls::Join& join);

 private:
  static constexpr unsigned kAll = C::kPackets;  ///< tokens that a channel of packets can hold
  static constexpr auto kShort = hls::WriterFifo::kShort;
  /// The FIFO of a writer whose reader always takes its tokens in the end (file comment).
  static constexpr auto kShortInFast = kFast<C> ? kShort : hls::WriterFifo::kHoldsAll;
  /// Steps that wait for the slices' decisions, of which a FIFO never holds more. A slice with
  /// reciprocals takes 8 clocks, FIFOs and buffers four; more would cost speed, not hits.
  static constexpr unsigned kSteps = kCommonOrigin<C> ? 16 : kAll;

  auto& pixel_reader() {
    if constexpr (kFast<C>) {
      return camera_rays;
    } else {
      return send_packet;
    }
  }

  /// The rays that a slice reads.
  void join_rays(hls::Join& join, unsigned i);
  auto& rays_written(unsigned i);
  /// The inputs of the mailbox.
  hls::Writers<MailboxEntry<C>> list_entries();
  template <class Lookup, class Fill>
  static void join_cache(hls::Join& join, const std::string& name, Lookup& lookup, Fill& fill);
};

template <class C>
std::vector<hls::Config<FrameRegisters<C>>*> Pipeline<C>::frame_readers() {
  std::vector<hls::Config<FrameRegisters<C>>*> readers = {
      &node_lookup.frame,   &node_fill.frame,   &list_lookup.frame, &list_fill.frame,
      &matrix_lookup.frame, &matrix_fill.frame, &mailbox.frame,     &shading.frame};
  if constexpr (C::kUncompressed || kTestsWorldBox<C>) readers.push_back(&matrix_store.frame);
  if constexpr (C::kUncompressed && kFast<C>) readers.push_back(&camera_rays.frame);
  if constexpr (C::kUncompressed && kHasLights<C>) readers.push_back(&packet_decoder.frame);
  if constexpr (kTestsWorldBox<C>) readers.push_back(&matrix_fetch.frame);
  if constexpr (kMainFirst<C>) readers.push_back(&list.frame);
  if constexpr (kHasSecondary<C>) {
    readers.insert(readers.end(), {&shader.frame, &secondary_rays.frame});
  }
  return readers;
}

template <class C>
void Pipeline<C>::join_shading(hls::Join& join, PixelPositions<C>& position) {
  join.ram("pixel_position", position, std::array{&pixel_reader().position, &shading.position});
  if constexpr (kHasSecondary<C>) {
    join.repeat("shade_job", hls::Writers{&node_fetch.top_done}, shader.job, kAll);
    join.repeat("write_job", hls::Writers{&secondary_rays.finished}, shading.job, kAll);
  } else {
    join.repeat("shade_job", hls::Writers{&node_fetch.top_done}, shading.job, kAll);
  }
  join.ram("hit_record", collect_hits.hit, std::array{&shading.hit});
}

}  // namespace dynrt

#include "units/join_caches.h"
#include "units/join_secondary.h"
#include "units/join_transformation.h"
#include "units/join_traversal.h"
