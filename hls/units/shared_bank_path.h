// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Shared bank path: the same for several pipelines, whose shadings write banks 3 to 5 through one
// unit.
#pragma once

#include "units/bank_path.h"
#include "units/frame_writer.h"

namespace dynrt {

template <class C>
struct SharedBankPath : BankPath<C> {
  FrameWriter<C> frame_writer;

  template <class J>
  void name_frame_units(J& join) {
    join.unit("frame_writer", "frame_writer", frame_writer);
  }
  auto& frame_end(PipelinesOf<C>& /*pipelines*/) { return frame_writer; }

  void join_frame_writes(hls::Join& join, PipelinesOf<C>& pipelines) {
    hls::Writers<FrameWrite<C>> writes = {};
    for (Pipeline<C>& p : pipelines) writes.push_back(&p.shading.write);
    join.channel<FrameWrite<C>>("frame_write", writes, {&frame_writer.write});
  }
  void join_frame_banks(hls::Join& join, const Banks<C>& banks, PipelinesOf<C>& /*pipelines*/) {
    this->join_written_banks(join, banks, frame_writer);
  }
};

}  // namespace dynrt
