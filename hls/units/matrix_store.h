// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Matrix store: keeps one matrix per packet for the transformation, column by column as the cache
// delivers them in any order, and sends the packet on when all are there (the storing half of the
// thesis's load matrix unit, 6.1.3). A triangle stored in three columns (5.1.1) is kept in four:
// the first of them brings the column of ones along. An object's box in the world is a single
// column, which is no part of a matrix and goes another way (units/world_box.h). Corners that a
// plane map will take have the origin of the packet's rays subtracted (units/plane_map.h).
#pragma once

#include "units/frame.h"
#include "units/memory_tokens.h"
#include "units/plane_map.h"
#include "units/transformation_tokens.h"

namespace dynrt {

/// A column of the cache is a MatrixColumn; its spare bits go to the job's record.
template <class C>
struct MatrixStore {
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
  hls::OptionalPort<kMapsBlocks<C>, hls::RamRead<Vector<Real>, kLevelRows<C>>>
      origin;  ///< of a packet's rays
  hls::Out<SendJob<C>> ready;
  hls::OptionalPort<kFast<C>, hls::Out<CameraJob<C>>> camera;
  hls::RamWrite<Vector<Real>, kPackets> column[4];
  /// Columns 0 to 2 of the camera's matrix, which all packets of a frame share, and its column 3.
  hls::OptionalPort<kFast<C>, hls::RamWrite<Vector<Real>, 1>> camera_column[3];
  hls::OptionalPort<kFast<C>, hls::RamWrite<Vector<Real>, kEyeRows<C>>> eye;
  hls::RamWrite<JobRecord<C>, kPackets> record;
  hls::OptionalPort<kTwoLevels<C>, hls::RamWrite<MatrixNumber<C>, kPackets>> object;
  hls::OptionalPort<kTestsWorldBox<C>, hls::Out<BoxJob<C>>> box;
  hls::OptionalPort<kTestsWorldBox<C>, hls::RamWrite<BoxedObject<C>, kPackets>> boxed;
  hls::RegisterFile<Progress, kPackets> progress;
  HLS_PORTS(reply, frame, origin, ready, camera, column, camera_column, eye, record, object, box,
            boxed)

  void step() {
    const auto r = reply.read();
    const PacketId<C> packet = r.context.packet;
    const Vector<Real> values = stored(r);
    const bool stored_three = three(r.context);
    store(r, values, stored_three);
    if constexpr (kFast<C>) store_camera(r, values);

    Progress p = progress.read(packet);
    const uint<2> last = stored_three ? uint<2>(kStoredColumns - 1) : uint<2>(3);
    const bool complete = p.columns == last;
    keep_extras(r, stored_three, p);
    const bool is_box = fetches_box<C>(r.context.kind, r.context.extras);
    if (r.context.column == uint<2>(1)) p.mirror = r.line.spare().template trunc<8>();
    if constexpr (kScalesCosine<C>) {
      if (r.context.column == last) {
        p.cosine_factor = Real::from_bits(r.line.spare().template trunc<Real::kLeafWidth>());
      }
    }
    count(complete, p);
    if (!is_box) progress.write(packet, p);
    if constexpr (kTestsWorldBox<C>) test_box(r, is_box);
    if (complete && !is_box) send_on(r, p);
  }

 private:
  /// Writes the column where it belongs.
  void store(const ColumnReply<C>& r, const Vector<Real>& values, bool stored_three) {
    const PacketId<C> packet = r.context.packet;
    if constexpr (kThreeColumns<C>) {
      const uint<2> ones = r.line.spare().template bits<17, 16>();
      const uint<2> place = stored_three ? place_of(r.context.column, ones) : r.context.column;
      const bool brings_ones = stored_three && r.context.column == uint<2>(0);
      for (unsigned c = 0; c < 4; ++c) {
        const bool is_ones = brings_ones && ones == uint<2>::from(c);
        if (is_ones || place == uint<2>::from(c)) {
          column[c].write(packet, is_ones ? kOnes : values);
        }
      }
    } else {
      for (unsigned c = 0; c < 4; ++c) {
        if (r.context.column == uint<2>::from(c)) column[c].write(packet, values);
      }
    }
  }
  /// Rays that are made beside the transformation have a camera's or a light's matrix.
  void store_camera(const ColumnReply<C>& r, const Vector<Real>& values) {
    const bool of_camera = r.context.kind == TransformKind::kCamera;
    const bool of_light = kLightsAtOnce<C> && r.context.kind == TransformKind::kSecondary;
    for (unsigned c = 0; c < 3; ++c) {
      if (of_camera && r.context.column == uint<2>::from(c)) camera_column[c].write({}, values);
    }
    if ((of_camera || of_light) && r.context.column == uint<2>(3)) {
      eye.write(eye_row<C>(r.context.packet), values);
    }
  }
  /// Spare bits of column 0, or of the first two of three that are stored.
  static void keep_extras(const ColumnReply<C>& r, bool stored_three, Progress& p) {
    if constexpr (C::kOneColour && !kTwoLevels<C>) {
      // The spare bits are not read.
    } else if constexpr (C::kOneColour || !kThreeColumns<C>) {
      if (r.context.column == uint<2>(0)) {
        p.extra = r.line.spare().template trunc<MatrixExtra<C>::kWidth>();
      }
    } else {
      // The row is behind one choice: its loop is short.
      const bool first = r.context.column == uint<2>(0);
      const bool second = r.context.column == uint<2>(1);
      const bool brings_high = stored_three ? second : first;
      const uint<8> high = stored_three ? r.line.spare().template bits<15, 8>()
                                        : r.line.spare().template bits<23, 16>();
      p.extra =
          hls::concat(brings_high ? high : p.extra.template bits<23, 16>(),
                      first ? r.line.spare().template trunc<16>() : p.extra.template trunc<16>());
    }
  }
  /// One column more has arrived.
  static void count(bool complete, Progress& p) {
    if constexpr (kThreeColumns<C>) {
      // Without an adder, for the loop's sake.
      const bool low = p.columns.template bit<0>();
      const bool high = p.columns.template bit<1>();
      p.columns = complete ? uint<2>(0) : hls::concat(uint<1>(high != low), uint<1>(!low));
    } else {
      p.columns = hls::next(p.columns);
    }
  }
  /// An object's box goes to its test with the rays that may enter.
  void test_box(const ColumnReply<C>& r, bool is_box) {
    const PacketId<C> packet = r.context.packet;
    const ColumnAddress<C> first = first_box<C>(frame.get(), r.context.extras);
    const auto behind = (r.address - first).as_unsigned();
    const auto rays = RepeatCount<C>::from(number_of(r.context.active).raw() - 1);
    if (is_box) {
      boxed.write(packet, BoxedObject<C>{behind.template trunc<C::kMatrixBits>(), r.context.active,
                                         slabs_of(r.line)});
      box.write(BoxJob<C>{rays, packet});
    }
  }
  /// The matrix is whole.
  void send_on(const ColumnReply<C>& r, const Progress& p) {
    const PacketId<C> packet = r.context.packet;
    const MatrixNumber<C> matrix = kThreeColumns<C>
                                       ? r.context.matrix.get()
                                       : r.address.template bits<C::kMatrixBits + 1, 2>();
    const auto& derived = r.context.extras.derived;
    record.write(packet,
                 JobRecord<C>{r.context.kind, r.context.active, p.extra, matrix, derived, p.mirror,
                              r.context.extras.distinct_origins.get(), r.context.extras.primitive,
                              p.cosine_factor, r.context.extras.viewpoint});
    if constexpr (kTwoLevels<C>) {
      if (r.context.kind == TransformKind::kObject) object.write(packet, matrix);
    }
    send_vectors(r);
  }
  /// The packet's vectors go through the transformation, or new rays are made beside it.
  void send_vectors(const ColumnReply<C>& r) {
    const PacketId<C> packet = r.context.packet;
    const auto& derived = r.context.extras.derived;
    SendJob<C> send;
    bool distinct_origins = r.context.extras.distinct_origins.get();
    if constexpr (C::kUncompressed) {
      distinct_origins = frame.get().uncompressed.get().template bit<0>() || distinct_origins;
    }
    const bool one_ray = kHasSecondary<C> && r.context.kind == TransformKind::kSecondary;
    const bool corners = kMapsCorners<C> && r.context.kind == TransformKind::kTriangle;
    const bool blocks = kMapsBlocks<C> && r.context.kind == TransformKind::kTriangle;
    if constexpr (kFast<C>) {
      // Every ray of a new packet begins, as its pixel is written.
      send.sent = r.context.kind == TransformKind::kCamera ? RayMask<C>::ones() : r.context.active;
      send.pairs = distinct_origins && !one_ray && !corners && !blocks;
      const RepeatCount<C> rays = number_of(send.sent.get());
      const auto pairs = RepeatCount<C>::from((rays + rays).raw());
      send.repeat = one_ray            ? RepeatCount<C>(1)
                    : corners          ? RepeatCount<C>::from((pairs + rays).raw() - 1)
                    : blocks           ? RepeatCount<C>::from(rays.raw() - 1)
                    : distinct_origins ? RepeatCount<C>::from(pairs.raw() - 1)
                                       : rays;
    } else {
      send.repeat = corners            ? RepeatCount<C>(3 * kRays<C> - 1)
                    : blocks           ? RepeatCount<C>(kRays<C> - 1)
                    : one_ray          ? RepeatCount<C>(1)
                    : distinct_origins ? RepeatCount<C>(2 * kRays<C> - 1)
                                       : RepeatCount<C>(kRays<C>);
    }
    send.packet = packet;
    send.kind = r.context.kind;
    send.derived = derived;
    const bool to_light = kLightsAtOnce<C> && send.kind == TransformKind::kSecondary;
    const bool beside = kFast<C> && (send.kind == TransformKind::kCamera || to_light);
    if constexpr (kFast<C>) {
      CameraJob<C> rays;
      rays.packet = packet;
      if constexpr (kLightsAtOnce<C>) {
        const RepeatCount<C> lit = number_of(r.context.active);
        rays.to_light = to_light;
        rays.lit = r.context.active;
        if (to_light) rays.repeat = RepeatCount<C>::from((lit + lit + lit).raw() - 1);
      }
      if (beside) camera.write(rays);
    }
    if (!beside) ready.write(send);
  }
  /// The column; of a corner, how it lies from the origin of the packet's rays.
  Vector<Real> stored(const ColumnReply<C>& r) const {
    const Vector<Real> values{r.line.row[0].value, r.line.row[1].value, r.line.row[2].value};
    if constexpr (kMapsBlocks<C>) {
      const Vector<Real> from = origin.read(level_row<C>(Level(1), r.context.packet));
      const Vector<Real> way{values.x - from.x, values.y - from.y, values.z - from.z};
      const bool normal = r.context.column == uint<2>(3);
      if (r.context.kind == TransformKind::kTriangle && !normal) {
        return as_column(block_vector(way));
      }
    }
    return values;
  }
  static RepeatCount<C> number_of(RayMask<C> mask) {
    RepeatCount<C> rays;
    for (unsigned i = 0; i < kRays<C>; ++i) {
      if (mask.bit(i)) rays = hls::next(rays);
    }
    return rays;
  }
  static constexpr Vector<Real> kOnes{Real::one(), Real::one(), Real::one()};

  static bool three(const ColumnContext<C>& context) {
    return kThreeColumns<C> && context.kind == TransformKind::kTriangle &&
           !is_primitive<C>(Primitive::kSphere, context.extras.primitive);
  }
  /// Where a stored column belongs: around the column of ones, the translation behind.
  static uint<2> place_of(uint<2> stored, uint<2> ones) {
    return stored == uint<2>(0)   ? uint<2>(uint<1>(ones == uint<2>(0)))
           : stored == uint<2>(1) ? (ones == uint<2>(2) ? uint<2>(1) : uint<2>(2))
                                  : uint<2>(3);
  }
};

}  // namespace dynrt
