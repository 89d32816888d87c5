// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins from the jobs of the transformation to the intersection's candidates.
#pragma once

#include "units/pipeline.h"

namespace dynrt {

template <class C>
void Pipeline<C>::join_transformation(hls::Join& join, hls::Out<TransformJob<C>>& camera) {
  hls::Writers<TransformJob<C>> jobs = {&mailbox.fresh};
  jobs.push_back(&camera, kShortInFast);
  if constexpr (kHasSecondary<C>) jobs.push_back(&secondary_rays.job);
  if constexpr (kTestsWorldBox<C>) jobs.push_back(&world_box.enter, kShortInFast);
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
    join.ram("column_" + std::to_string(c), matrix_store.column[c],
             std::array{&transformation.column[c]});
  }
  if constexpr (kFast<C>) {
    for (unsigned c = 0; c < 3; ++c) {
      join.ram("camera_column_" + std::to_string(c), matrix_store.camera_column[c],
               std::array{&camera_rays.column[c]});
    }
    join.ram("eye", matrix_store.eye, std::array{&camera_rays.eye});
  }
  std::vector records = {&packet_decoder.record, &collect_hits.record};
  if constexpr (kPairsUnitRays<C> && kMarksUnitRays<C>) records.push_back(&unit_decoder.record);
  join.ram("job_record", matrix_store.record, records);
  if constexpr (kTwoLevels<C>) {
    join.ram("object", matrix_store.object, std::array{&collect_hits.object});
  }
  if constexpr (kTestsWorldBox<C>) {
    join.repeat("box_job", hls::Writers{&matrix_store.box}, world_box.job, kAll);
    join.ram("boxed_object", matrix_store.boxed, std::array{&world_box.object});
    join.ram("world_reciprocal", ray_reciprocal.in_world, std::array{&world_box.reciprocal});
    for (unsigned i = 0; i < kRays<C>; ++i) {
      join.ram("box_" + std::to_string(i), world_box.interval[i], std::array{&slice[i].box});
    }
    join.ram("reach", collect_hits.reach, std::array{&world_box.reach});
  }
  constexpr auto kReady = kHasLights<C> ? hls::WriterFifo::kHoldsAll : kShortInFast;
  join.repeat("send_job", hls::Writers(&matrix_store.ready, kReady), send_packet.job, kAll);
  std::vector vectors = {&send_packet.vectors};
  if constexpr (kHasLights<C>) vectors.push_back(&shader.vectors);
  join.ram("ray_vectors", packet_decoder.vectors, vectors);
  join.channel("packet_vector", send_packet.vector, transformation.vector);
  hls::Writers<PacketVector<C>> rays = {&transformation.transformed};
  hls::Writers<UnitRay<C>> unit_rays = {};
  if constexpr (kFast<C>) {
    join.repeat("camera_job", hls::Writers(&matrix_store.camera, kShortInFast), camera_rays.job,
                kAll);
    rays.push_back(&camera_rays.vector);
  }
  if constexpr (kPairsUnitRays<C>) {
    join.channel("in_unit_space", transformation.in_unit_space, unit_decoder.vector);
    unit_rays.push_back(&unit_decoder.unit_ray);
  }
  if constexpr (kMapsBlocks<C>) {
    join.ram("plane_map", ray_reciprocal.map, std::array{&transformation.plane_map});
    unit_rays.push_back(&transformation.in_plane);
  }
  join.channel<PacketVector<C>>("transformed", rays, {&packet_decoder.vector});
  if constexpr (kFast<C>) {
    join.repeat("traced_ray", hls::Writers{&packet_decoder.traced}, ray_reciprocal.traced);
    // The clocks that a ray waits depend on those before it.
    join.depends_on_order({"ray_reciprocal"});
    unit_rays.push_back(&ray_reciprocal.reset);
  } else {
    unit_rays.push_back(&packet_decoder.unit_ray);
  }
  if constexpr (kMapsCorners<C>) {
    join.channel("object_ray", packet_decoder.object_ray, ray_shear.ray);
    join.ram("ray_map", ray_shear.map, std::array{&transformation.map});
  }
  join.channel<UnitRay<C>>("unit_ray", unit_rays, {&intersection.unit_ray});
  join.channel("candidate", intersection.candidate, collect_hits.candidate);
}

}  // namespace dynrt
