// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shared bank writer: the end of the shading in a core of several pipelines, whose writes go
// through one unit to the banks (units/frame_writer.h).
#pragma once

#include "units/bank_writer.h"
#include "units/pipelines.h"

namespace dynrt {

template <class C>
struct SharedBankWriter : RoundByRound<C>, PipelineOf<C> {
  hls::Out<FrameWrite<C>> write;
  using PortsOfParts = hls::Parts<PipelineOf<C>>;
  HLS_PORTS(write)

  void put(FrameWrite<C> w, RayIndex<C> ray, uint<2> word) {
    w.has_pixel = w.has_pixel && this->is_pixels_turn(ray, word);
    w.packet.pipeline = this->number();
    if (w.has_pixel || w.has_hit || w.last) write.write(w);
  }
};

}  // namespace dynrt
