// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The rays of a frame in doubles, made from true hits (thesis 6.2): the rays that the core would
// trace if it had all digits.
#pragma once

#include <optional>

#include "host/analysis/truth/truth.h"
#include "host/scene/scene.h"

namespace dynrt::host {

/// Shares of the distance: a light ray's shadows end this far before its surface, and a reflected
/// ray begins this far behind its surface (the margins of units/collect_hits.h).
inline constexpr double kSurfaceMargin = 1.0 / 512;

/// Through the centre of pixel (x, y), x from the left and y from the top: origin and direction as
/// camera_matrix() (host/layout/frame_image.h) defines them, so that t is comparable.
TruthRay primary_ray(const Camera& camera, unsigned width, unsigned height, unsigned x, unsigned y);

/// From a light to the hit of `ray`, at t = 1 (6.2.2). A hit before it is a shadow; the surface
/// itself is ignored, unless it is an ellipsoid, whose far side is in its own shadow.
TruthRay light_ray(const Scene& scene, const PointLight& light, const TruthRay& ray,
                   const TruthHit& hit);

/// The reflection by the hit triangle or rectangle (6.2.3): the ray taken into the object, mirrored
/// at the plane and taken back; it keeps t, so it starts behind the hit's. Nothing for an
/// ellipsoid.
std::optional<TruthRay> reflection_ray(const Scene& scene, const TruthRay& ray,
                                       const TruthHit& hit);

}  // namespace dynrt::host
