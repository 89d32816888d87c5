// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Packet decoder: puts a packet's transformed vectors together again (thesis 6.1.3). World and
// object rays are saved for the traversal and for later transformations; rays in unit triangle
// space, or the triangle's corners that were mapped to a ray's, go to the intersection, unless a
// unit of their own does that (units/unit_decoder.h). A camera's rays are new: the intersection
// passes a reset for each, as for every light and reflected ray when it is ready.
#pragma once

#include "units/frame.h"
#include "units/intersection_tokens.h"
#include "units/lane_spacing.h"
#include "units/packet_rays.h"
#include "units/send_packet.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

template <class C>
struct PacketDecoder {
  using Real = typename C::Real;
  static constexpr unsigned kPackets = 1u << PacketId<C>::kWidth;

  hls::In<PacketVector<C>> vector;
  hls::RamRead<JobRecord<C>, kPackets> record;
  hls::OptionalPort<kHasLights<C> && C::kUncompressed, hls::Config<FrameRegisters<C>>> frame;
  hls::OptionalPort<!kFast<C>, hls::Out<UnitRay<C>>> unit_ray;
  hls::OptionalPort<kTwoLevels<C> && !kMapsCorners<C> && !kFast<C>, hls::Out<TraversalEvent<C>>>
      enter_object;
  hls::OptionalPort<kMapsCorners<C>, hls::Out<ObjectRay<C>>> object_ray;
  hls::OptionalPort<kFast<C>, hls::Out<TracedRay<C>>> traced;
  hls::OptionalPort<!kFast<C>, hls::RamWrite<SliceRay<C>, kLevelRows<C>>> ray[kRays<C>];
  hls::OptionalPort<kSplitsPackets<C>, hls::RamWrite<DirectionSigns, kLevelRows<C>>>
      signs[kRays<C>];
  hls::RamWrite<Vector<Real>, kVectorRows<C>> vectors;
  /// The world rays, each with its origin; light rays, which nothing is derived from, left out.
  hls::OptionalPort<kHasSecondary<C>, hls::RamWrite<Ray<Real>, kRayRows<C>>> arriving;
  /// A pass that is not a ray's last.
  hls::OptionalPort<kTwoLevels<C> && kHasMirrors<C>, hls::Out<DerivationEvent<C>>> derived;
  HLS_PORTS(vector, record, frame, unit_ray, enter_object, object_ray, traced, ray, signs, vectors,
            arriving, derived)

  void step() {
    const PacketVector<C> in = vector.read();
    const JobRecord<C> job = record.read(in.packet);
    const Ray<Real> r{origin_of(in, job), in.vector};

    const bool triangle = !kFast<C> && job.kind == TransformKind::kTriangle;
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
    if (!in.point) {
      for (unsigned i = 0; i < kRays<C>; ++i) {
        if (!triangle && in.ray == RayIndex<C>::from(i)) {
          if constexpr (!kFast<C>) ray[i].write(row, slice_ray<C>(r));
          if constexpr (kSplitsPackets<C>) signs[i].write(row, signs_of(in.vector));
        }
      }
      const bool object = job.kind == TransformKind::kObject;
      if constexpr (kFast<C>) {
        TracedRay<C> trace;
        trace.is_new = is_new;
        trace.ray = in_object(in, job, r);
        if (is_new || object) {
          LaneSpacing<C> spacing = spacing_.get();
          trace.repeat = RepeatCount<C>::from(spacing.wait(in.ray).raw());
          spacing_ = spacing;
          traced.write(trace);
        }
      }
      if constexpr (kMapsCorners<C>) {
        UnitRay<C> test;
        test.packet = in.packet;
        test.ray = in.ray;
        test.reset = is_new;
        test.last = in.last;
        test.unit = {first_corner_.get(), second_corner_.get(), in.vector, in.cosine.get()};
        if (is_new || (triangle && in.corner.get() == Corner(2))) unit_ray.write(test);
        if (in.corner.get() == Corner(0)) first_corner_ = in.vector;
        if (in.corner.get() == Corner(1)) second_corner_ = in.vector;
        if (object) enter(in, job, r);
      } else if constexpr (!kFast<C>) {
        if (triangle || is_new) unit_ray.write(unit_ray_of(in, job, is_new, r));
        if (object) enter(in, job, r);
      }
    }
  }

 private:
  bool has_pairs() const {
    if constexpr (kHasLights<C> && C::kUncompressed) {
      return frame.get().uncompressed.get().template bit<0>();
    } else {
      return false;
    }
  }
  /// Of a camera's rays, whose vectors come between those of another packet, and of all others. A
  /// light's may be among them.
  Vector<Real> origin_of(const PacketVector<C>& in, const JobRecord<C>& job) {
    if constexpr (kFast<C>) {
      const bool camera = job.kind == TransformKind::kCamera ||
                          (kLightsAtOnce<C> && job.kind == TransformKind::kSecondary);
      if (in.point && camera) camera_origin_ = in.vector;
      if (in.point && !camera) origin_ = in.vector;
      return camera ? camera_origin_.get() : origin_;
    } else {
      if (in.point) origin_ = in.vector;
      return origin_;
    }
  }
  static OfInstance<C, NodeAddress<C>> root_of(const JobRecord<C>& job) {
    if constexpr (kTwoLevels<C>) {
      return job.extra.template trunc<C::kAddressBits>();
    } else {
      return {};
    }
  }
  static ObjectRay<C> in_object(const PacketVector<C>& in, const JobRecord<C>& job,
                                const Ray<Real>& r) {
    return {in.packet, in.ray, job.active, root_of(job), in.last, job.distinct_origins, r};
  }
  void enter(const PacketVector<C>& in, const JobRecord<C>& job, const Ray<Real>& r) {
    if constexpr (kFast<C> || !kTwoLevels<C>) {
      return;
    } else if constexpr (kMapsCorners<C>) {
      object_ray.write(in_object(in, job, r));
    } else if (is_last_ray<C>(in.ray, in.last)) {
      enter_object.write(enter_tree(in_object(in, job, r), job.active));
    }
  }
  static DirectionSigns signs_of(const Vector<Real>& v) {
    return hls::concat(uint<1>(v.z.sign()), hls::concat(uint<1>(v.y.sign()), uint<1>(v.x.sign())));
  }
  Vector<Real> origin_;  ///< of the packet, whose vectors come one after the other
  hls::OptionalField<kFast<C>, Vector<Real>> camera_origin_;
  hls::OptionalField<kFast<C>, LaneSpacing<C>> spacing_;  ///< of traced rays
  /// Of the triangle that is being mapped.
  hls::OptionalField<kMapsCorners<C>, Vector<Real>> first_corner_;
  hls::OptionalField<kMapsCorners<C>, Vector<Real>> second_corner_;
};

}  // namespace dynrt
