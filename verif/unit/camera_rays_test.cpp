// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/camera_rays.h"

#include "Vcamera_rays.h"
#include "camera_rays_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<CameraRays<C>>&, const Run&) {}

DYNRT_COSIM(CameraRays, CameraRays<C>, camera_rays, setup)

}  // namespace
}  // namespace dynrt::cosim
