// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The joins of light and reflection rays (thesis 6.2).
#pragma once

#include "units/pipeline.h"

namespace dynrt {

template <class C>
void Pipeline<C>::join_secondary(hls::Join& join) {
  hls::Writers<DerivationEvent<C>> derive = {&shader.derive};
  if constexpr (!kLightsAtOnce<C>) derive.push_back(&collect_hits.derived);
  std::vector<hls::RamRead<SurfacePoint<C>, kRayRows<C>>*> surface;
  if constexpr (kHasMirrors<C>) surface.push_back(&secondary_rays.surface);
  surface.push_back(&collect_hits.surface);
  std::vector<hls::RamRead<Ray<typename C::Real>, kRayRows<C>>*> arriving;
  if constexpr (kHasLights<C>) {
    if constexpr (kLightsAtOnce<C>) {
      arriving.push_back(&camera_rays.arriving);
      surface.push_back(&camera_rays.surface);
    } else {
      arriving.push_back(&light_columns.arriving);
      surface.push_back(&send_packet.surface);
    }
    join.ram("light", light_columns.light, std::array{&shader.light});
  }
  if constexpr (kHasMirrors<C>) {
    if constexpr (kTwoLevels<C>) derive.push_back(&packet_decoder.derived);
    arriving.push_back(&send_packet.arriving);
    for (unsigned i = 0; i < kRays<C>; ++i) {
      join.ram("start_distance_" + std::to_string(i), collect_hits.start_distance[i],
               std::array{&slice[i].start_distance});
    }
  }
  join.channel<DerivationEvent<C>>("derive", derive, {&secondary_rays.derive}, kAll);
  join.ram("arriving_ray", packet_decoder.arriving, arriving);
  join.ram("surface_point", shader.surface, surface);
  join.ram("traced", secondary_rays.traced, std::array{&shader.traced});
  join.ram("found", collect_hits.found, std::array{&shader.found});
  join.ram("pixel_colour", shader.pixel_colour, std::array{&shading.pixel_colour});
}

}  // namespace dynrt
