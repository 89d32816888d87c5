// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A part of the matrix store: what is stored of a column. Of the corner of a triangle that a plane
// map will take (units/plane_map.h), how it lies from the origin of the packet's rays.
#pragma once

#include "units/memory_tokens.h"
#include "units/plane_map.h"
#include "units/transformation_tokens.h"

namespace dynrt {

template <class C>
struct WholeColumns {
  HLS_NO_PORTS
  static Vector<typename C::Real> stored(const ColumnReply<C>& r) {
    return {r.line.row[0].value, r.line.row[1].value, r.line.row[2].value};
  }
};

template <class C>
struct CornersFromOrigin {
  using Real = typename C::Real;
  hls::RamRead<Vector<Real>, kLevelRows<C>> origin;  ///< of a packet's rays
  HLS_PORTS(origin)

  Vector<Real> stored(const ColumnReply<C>& r) const {
    const Vector<Real> values = WholeColumns<C>::stored(r);
    const Vector<Real> from = origin.read(level_row<C>(Level(1), r.context.packet));
    const Vector<Real> way{values.x - from.x, values.y - from.y, values.z - from.z};
    const bool normal = r.context.column == uint<2>(3);
    if (r.context.kind == TransformKind::kTriangle && !normal) {
      return as_column(block_vector(way));
    }
    return values;
  }
};

}  // namespace dynrt
