// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Embree 3 (Debian 12) and Embree 4 (Debian 13) under one interface: the folder of the header, and
// the context that goes with a ray, differ.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

namespace dynrt::host {

struct EmbreeRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using EmbreeDevice = std::unique_ptr<std::remove_pointer_t<RTCDevice>, EmbreeRelease>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, EmbreeRelease>;

#if RTC_VERSION_MAJOR >= 4

/// Goes with a ray to the callbacks of user geometry.
using EmbreeContext = RTCRayQueryContext;

inline void intersect(const EmbreeScene& scene, EmbreeContext& context, RTCRayHit& hit) {
  rtcInitRayQueryContext(&context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene.get(), &hit, &arguments);
}

#else

using EmbreeContext = RTCIntersectContext;

inline void intersect(const EmbreeScene& scene, EmbreeContext& context, RTCRayHit& hit) {
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene.get(), &context, &hit);
}

#endif

}  // namespace dynrt::host
