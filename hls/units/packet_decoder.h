// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Packet decoder: puts a packet's transformed vectors together again (thesis 6.1.3). World and
// object rays are saved for later transformations. Where whole rays go is a part: to the slices
// (units/decoded_rays.h), by way of a shear (units/decoded_corners.h), or by way of the reciprocals
// (units/traced_rays.h).
#pragma once

#include <type_traits>

#include "units/decoded_corners.h"
#include "units/decoded_rays.h"
#include "units/frame.h"
#include "units/send_packet.h"
#include "units/shading_tokens.h"
#include "units/traced_rays.h"

namespace dynrt {

template <class C>
using DecodedRays =
    std::conditional_t<kFast<C>, RaysToReciprocals<C>,
                       std::conditional_t<kMapsCorners<C>, RaysToShear<C>, RaysToSlices<C>>>;

template <class C>
struct PacketDecoder : DecodedRays<C> {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<PacketVector<C>> vector;
  hls::RamRead<JobRecord<C>, kPackets> record;
  hls::OptionalPort<kHasLights<C> && C::kUncompressed, hls::Config<FrameRegisters<C>>> frame;
  hls::OptionalPort<kSplitsPackets<C>, hls::RamWrite<DirectionSigns, kLevelRows<C>>>
      signs[kRays<C>];
  hls::RamWrite<Vector<Real>, kVectorRows<C>> vectors;
  /// The world rays, each with its origin; light rays, which nothing is derived from, left out.
  hls::OptionalPort<kHasSecondary<C>, hls::RamWrite<Ray<Real>, kRayRows<C>>> arriving;
  /// A pass that is not a ray's last.
  hls::OptionalPort<kTwoLevels<C> && kHasMirrors<C>, hls::Out<DerivationEvent<C>>> derived;
  using PortsOfParts = hls::Parts<DecodedRays<C>>;
  HLS_PORTS(vector, record, frame, signs, vectors, arriving, derived)

  void step() {
    const PacketVector<C> in = vector.read();
    const JobRecord<C> job = record.read(in.packet);
    const Ray<Real> r{this->origin_of(in, job), in.vector};

    const bool triangle = DecodedRays<C>::kGetsTriangles && job.kind == TransformKind::kTriangle;
    const bool alone = kHasSecondary<C> && job.kind == TransformKind::kSecondary;
    const Derivation pass = job.derived.get().pass;
    const bool light = kHasLights<C> && alone && pass == Derivation::kLight;
    const bool between = kTwoLevels<C> && kHasMirrors<C> && alone &&
                         (pass == Derivation::kIntoObject || pass == Derivation::kMirror);
    const bool is_new = job.kind == TransformKind::kCamera || (alone && !between);
    const Level level = uint<1>(job.kind == TransformKind::kObject || between);
    const LevelRow<C> row = level_row<C>(level, in.packet);
    // All light rays of a packet have one origin, the light, and lie as the frame's packets do.
    const RayIndex<C> slot = light && in.point && !has_pairs() ? RayIndex<C>{} : in.ray;
    if (!triangle && !(kCommonOrigin<C> && in.point)) {
      vectors.write(vector_row<C>(row, slot, in.point), in.vector);
    }
    if constexpr (kHasSecondary<C>) {
      if (!in.point && is_new && !light) arriving.write(ray_row<C>(in.packet, in.ray), r);
    }
    if constexpr (kTwoLevels<C> && kHasMirrors<C>) {
      if (!in.point && between) {
        DerivationEvent<C> go_on;
        go_on.packet = in.packet;
        derived.write(go_on);
      }
    }
    if constexpr (kSplitsPackets<C>) {
      for (unsigned i = 0; i < kRays<C>; ++i) {
        if (!in.point && !triangle && in.ray == RayIndex<C>::from(i)) {
          signs[i].write(row, signs_of(in.vector));
        }
      }
    }
    if (!in.point) this->pass_on(in, job, r, row, is_new);
  }

 private:
  bool has_pairs() const {
    if constexpr (kHasLights<C> && C::kUncompressed) {
      return frame.get().uncompressed.get().template bit<0>();
    } else {
      return false;
    }
  }
  static DirectionSigns signs_of(const Vector<Real>& v) {
    return hls::concat(uint<1>(v.z.sign()), hls::concat(uint<1>(v.y.sign()), uint<1>(v.x.sign())));
  }
};

}  // namespace dynrt
