// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Matrix store: keeps one matrix per packet for the transformation, column by column as the cache
// delivers them in any order, and sends the packet on when all four are there (the storing half of
// the thesis's load matrix unit, 6.1.3).
#pragma once

#include "units/frame.h"
#include "units/tokens.h"

namespace dynrt {

/// A column of the cache is a MatrixColumn; its spare bytes go to the job's record.
template <class C>
struct MatrixStore {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  struct Progress {
    uint<2> columns;                               ///< of this job that have arrived
    uint<24> extra;                                ///< spare bytes of column 0
    hls::FieldIf<kHasMirrors<C>, uint<8>> mirror;  ///< spare byte of column 1, row 0
    HLS_FIELDS(columns, extra, mirror)
  };

  hls::In<CacheReply<ColumnContext<C>, MatrixColumn>> reply;
  hls::Config<FrameConfig> frame;
  hls::Out<SendJob<C>> ready;
  hls::RamWrite<Vector<Real>, kPackets> column[4];
  hls::RamWrite<JobRecord<C>, kPackets> record;
  hls::RamWrite<MatrixIndex, kPackets> object;
  hls::RegisterFile<Progress, kPackets> progress;
  HLS_PORTS(reply, frame, ready, column[0], column[1], column[2], column[3], record, object)

  void step() {
    const auto r = reply.read();
    const PacketId<C> packet = r.context.packet;
    const Vector<Real> values{Real(r.line.row[0].value), Real(r.line.row[1].value),
                              Real(r.line.row[2].value)};
    for (unsigned c = 0; c < 4; ++c) {
      if (r.context.column == uint<2>::from(c)) column[c].write(packet, values);
    }

    Progress p = progress.read(packet);
    const bool complete = p.columns == uint<2>(3);
    if (r.context.column == uint<2>(0)) {
      p.extra =
          hls::concat(r.line.row[2].spare, hls::concat(r.line.row[1].spare, r.line.row[0].spare));
    }
    if (r.context.column == uint<2>(1)) p.mirror = r.line.row[0].spare;
    p.columns = hls::next(p.columns);
    progress.write(packet, p);

    if (complete) {
      const MatrixIndex matrix = r.address.template bits<kAddressBits - 1, 2>();
      const auto& derived = r.context.extras.derived;
      record.write(packet, JobRecord<C>{r.context.kind, r.context.active, matrix, p.extra, derived,
                                        p.mirror, r.context.extras.apart.get()});
      if (r.context.kind == TransformKind::kObject) object.write(packet, matrix);
      SendJob<C> send;
      const bool apart = frame.get().uncompressed.template bit<0>() || r.context.extras.apart.get();
      const bool one_ray = kHasSecondary<C> && r.context.kind == TransformKind::kDerive;
      send.repeat = one_ray ? RepeatCount(1) : apart ? RepeatCount(7) : RepeatCount(4);
      send.packet = packet;
      send.kind = r.context.kind;
      send.derived = derived;
      ready.write(send);
    }
  }
};

}  // namespace dynrt
