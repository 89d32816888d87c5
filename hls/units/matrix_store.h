// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Matrix store: keeps one matrix per packet for the transformation, column by column as the cache
// delivers them in any order, and sends the packet on when all are there (the storing half of the
// thesis's load matrix unit, 6.1.3). Its parts are the columns of a triangle
// (units/stored_triangle.h, units/stored_corners.h) and what becomes of a packet whose matrix is
// whole (units/send_jobs.h, units/send_active.h).
#pragma once

#include <type_traits>

#include "units/frame.h"
#include "units/memory_tokens.h"
#include "units/send_active.h"
#include "units/send_jobs.h"
#include "units/stored_corners.h"
#include "units/stored_triangle.h"
#include "units/transformation_tokens.h"

namespace dynrt {

template <class C>
using SendJobs = std::conditional_t<kFast<C>, SendActiveRays<C>, SendAllRays<C>>;
template <class C>
using BoxStore = std::conditional_t<kTestsWorldBox<C>, BoxColumns<C>, NoBoxColumns<C>>;
template <class C>
using StoredCorners = std::conditional_t<kMapsBlocks<C>, CornersFromOrigin<C>, WholeColumns<C>>;

/// A column of the cache is a MatrixColumn; its spare bits go to the job's record.
template <class C>
struct MatrixStore : StoredTriangle<C>, StoredCorners<C>, SendJobs<C>, BoxStore<C> {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;
  static constexpr unsigned kRoom = kRoomForBursts<C>;
  struct Progress {
    uint<2> columns;                                     ///< of this job that have arrived
    MatrixExtra<C> extra;                                ///< spare bits of column 0
    hls::OptionalField<kHasMirrors<C>, uint<8>> mirror;  ///< spare bits of column 1
    hls::OptionalField<kScalesCosine<C>, Real> cosine_factor;
    HLS_FIELDS(columns, extra, mirror, cosine_factor)
  };

  hls::In<ColumnReply<C>> reply;
  hls::OptionalPort<C::kUncompressed || kTestsWorldBox<C>, hls::Config<FrameRegisters<C>>> frame;
  hls::RamWrite<JobRecord<C>, kPackets> record;
  hls::OptionalPort<kTwoLevels<C>, hls::RamWrite<MatrixNumber<C>, kPackets>> object;
  hls::RegisterFile<Progress, kPackets> progress;
  using PortsOfParts = hls::Parts<StoredTriangle<C>, StoredCorners<C>, SendJobs<C>, BoxStore<C>>;
  HLS_PORTS(reply, frame, record, object)

  void step() {
    const auto r = reply.read();
    const PacketId<C> packet = r.context.packet;
    const Vector<Real> values = this->stored(r);
    const bool is_short = this->is_short(r.context);
    this->store(r, values, is_short);
    this->store_camera(r, values);

    Progress p = progress.read(packet);
    const uint<2> last = is_short ? uint<2>(kStoredColumns - 1) : uint<2>(3);
    const bool complete = p.columns == last;
    this->keep_extra(r, is_short, p.extra);
    const bool is_box = fetches_box<C>(r.context.kind, r.context.extras);
    if (r.context.column == uint<2>(1)) p.mirror = r.line.spare().template trunc<8>();
    if constexpr (kScalesCosine<C>) {
      if (r.context.column == last) {
        p.cosine_factor = Real::from_bits(r.line.spare().template trunc<Real::kLeafWidth>());
      }
    }
    p.columns = this->count(p.columns, complete);
    if (!is_box) progress.write(packet, p);
    if constexpr (kTestsWorldBox<C>) this->test_box(r, frame.get(), is_box);
    if (complete && !is_box) send_whole(r, p);
  }

 private:
  /// The matrix is whole.
  void send_whole(const ColumnReply<C>& r, const Progress& p) {
    const PacketId<C> packet = r.context.packet;
    const MatrixNumber<C> matrix = this->matrix_of(r);
    const TransformExtras<C>& extras = r.context.extras;
    record.write(packet, JobRecord<C>{r.context.kind, r.context.active, p.extra, matrix,
                                      extras.derived, p.mirror, extras.distinct_origins.get(),
                                      extras.primitive, p.cosine_factor, extras.viewpoint});
    if constexpr (kTwoLevels<C>) {
      if (r.context.kind == TransformKind::kObject) object.write(packet, matrix);
    }
    const bool triangle = r.context.kind == TransformKind::kTriangle;
    SentVectors sent{kHasSecondary<C> && r.context.kind == TransformKind::kSecondary,
                     kMapsCorners<C> && triangle, kMapsBlocks<C> && triangle,
                     extras.distinct_origins.get()};
    if constexpr (C::kUncompressed) {
      sent.distinct_origins =
          frame.get().uncompressed.get().template bit<0>() || sent.distinct_origins;
    }
    this->send_on(r, sent);
  }
};

}  // namespace dynrt
