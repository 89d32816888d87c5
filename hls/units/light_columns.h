// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Light columns: makes the matrix of a light ray (thesis 6.2.2), on the way from the matrix cache
// to the matrix store. In the memory a light is a matrix: columns 2 and 3 hold its position, row 0
// of column 0 its intensity, the spare bits of column 0 its colour. Columns 0 and 1 of the matrix
// that makes the ray are origin and direction of the ray that hit the surface. Where a packet's
// light rays are made at once (units/camera_rays.h), the matrix stays as it is for all of them.
#pragma once

#include "units/memory_tokens.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

/// The light of a packet's light rays.
template <class C>
struct LightPower {
  typename C::Real intensity;
  uint<24> colour;  ///< red lowest
  HLS_FIELDS(intensity, colour)
};

template <class C>
struct LightColumns {
  using Real = typename C::Real;
  using Column = ColumnReply<C>;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<Column> fetched;
  hls::Out<Column> column;
  hls::OptionalPort<!kLightsAtOnce<C>, hls::RamRead<Ray<Real>, kRayRows<C>>> arriving;
  hls::RamWrite<LightPower<C>, kPackets> light;
  HLS_PORTS(fetched, column, arriving, light)

  void step() {
    Column c = fetched.read();
    const DerivedRay<C> derived = c.context.extras.derived.get();
    const bool is_light =
        c.context.kind == TransformKind::kSecondary && derived.pass == Derivation::kLight;
    const bool first = c.context.column == uint<2>(0);
    if (is_light && first) {
      light.write(c.context.packet,
                  LightPower<C>{c.line.row[0].value, c.line.spare().template trunc<24>()});
    }
    if constexpr (!kLightsAtOnce<C>) {
      const Ray<Real> ray = arriving.read(ray_row<C>(c.context.packet, derived.ray));
      if (is_light && !c.context.column.template bit<1>()) {
        const Vector<Real> v = first ? ray.origin : ray.direction;
        c.line.row[0].value = v.x;
        c.line.row[1].value = v.y;
        c.line.row[2].value = v.z;
      }
    }
    column.write(c);
  }
};

}  // namespace dynrt
