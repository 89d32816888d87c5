// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/frame_writer.h"

#include "Vframe_writer.h"
#include "frame_writer_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<FrameWriter<C>>& /*bench*/, const Run& /*run*/) {}

DYNRT_COSIM(FrameWriter, FrameWriter<C>, frame_writer, setup)

}  // namespace
}  // namespace dynrt::cosim
