// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Parts of the matrix store of a fast core. The rays that are in a leaf are sent alone. A camera's
// rays and a light's are made beside the transformation, from columns that are kept for that
// (units/camera_rays.h). An object's box in the world is a single column, which is no part of a
// matrix and goes to its test (units/world_box.h).
#pragma once

#include "units/send_jobs.h"

namespace dynrt {

template <class C>
RepeatCount<C> number_of_rays(RayMask<C> mask) {
  RepeatCount<C> rays;
  for (unsigned i = 0; i < kRays<C>; ++i) {
    if (mask.bit(i)) rays = hls::next(rays);
  }
  return rays;
}

template <class C>
struct SendActiveRays {
  using Real = typename C::Real;
  hls::Out<SendJob<C>> ready;
  hls::Out<CameraJob<C>> camera;
  /// Columns 0 to 2 of the camera's matrix, which all packets of a frame share, and its column 3.
  hls::RamWrite<Vector<Real>, 1> camera_column[3];
  hls::RamWrite<Vector<Real>, kEyeRows<C>> eye;
  HLS_PORTS(ready, camera, camera_column, eye)

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
  void send_on(const ColumnReply<C>& r, const SentVectors& v) {
    SendJob<C> send;
    // Every ray of a new packet begins, as its pixel is written.
    send.sent = r.context.kind == TransformKind::kCamera ? RayMask<C>::ones() : r.context.active;
    send.pairs = v.distinct_origins && !v.one_ray && !v.corners && !v.blocks;
    const RepeatCount<C> rays = number_of_rays<C>(send.sent.get());
    const auto pairs = RepeatCount<C>::from((rays + rays).raw());
    send.repeat = v.one_ray            ? RepeatCount<C>(1)
                  : v.corners          ? RepeatCount<C>::from((pairs + rays).raw() - 1)
                  : v.blocks           ? RepeatCount<C>::from(rays.raw() - 1)
                  : v.distinct_origins ? RepeatCount<C>::from(pairs.raw() - 1)
                                       : rays;
    send.packet = r.context.packet;
    send.kind = r.context.kind;
    send.derived = r.context.extras.derived;
    const bool to_light = kLightsAtOnce<C> && send.kind == TransformKind::kSecondary;
    const bool beside = send.kind == TransformKind::kCamera || to_light;
    CameraJob<C> new_rays;
    new_rays.packet = r.context.packet;
    if constexpr (kLightsAtOnce<C>) {
      const RepeatCount<C> lit = number_of_rays<C>(r.context.active);
      new_rays.to_light = to_light;
      new_rays.lit = r.context.active;
      if (to_light) new_rays.repeat = RepeatCount<C>::from((lit + lit + lit).raw() - 1);
    }
    if (beside) camera.write(new_rays);
    if (!beside) ready.write(send);
  }
};

template <class C>
struct NoBoxColumns {
  HLS_NO_PORTS
  void test_box(const ColumnReply<C>& /*reply*/, const FrameRegisters<C>& /*frame*/,
                bool /*is_box*/) {}
};
template <class C>
struct BoxColumns {
  hls::Out<BoxJob<C>> box;
  hls::RamWrite<BoxedObject<C>, 1u << PacketId<C>::kWidth> boxed;
  HLS_PORTS(box, boxed)

  /// An object's box goes to its test with the rays that may enter.
  void test_box(const ColumnReply<C>& r, const FrameRegisters<C>& frame, bool is_box) {
    const PacketId<C> packet = r.context.packet;
    const ColumnAddress<C> first = first_box<C>(frame, r.context.extras);
    const auto behind = (r.address - first).as_unsigned();
    const auto rays = RepeatCount<C>::from(number_of_rays<C>(r.context.active).raw() - 1);
    if (is_box) {
      boxed.write(packet, BoxedObject<C>{behind.template trunc<C::kMatrixBits>(), r.context.active,
                                         slabs_of(r.line)});
      box.write(BoxJob<C>{rays, packet});
    }
  }
};

}  // namespace dynrt
