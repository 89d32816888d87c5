// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Matrix fetch: asks the matrix cache for the columns of an object's, a triangle's or the camera's
// matrix, one a clock (the reading half of the thesis's load matrix unit, 6.1.3): for all four, or,
// where triangles are stored in three (5.1.1), for those. An object's box in the world is one
// column (units/world_box.h).
#pragma once

#include "units/frame.h"
#include "units/memory_tokens.h"
#include "units/repeated.h"
#include "units/shading_tokens.h"
#include "units/transformation_tokens.h"

namespace dynrt {

template <class C>
struct MatrixFetch {
  hls::In<Repeated<TransformJob<C>>> job;
  hls::OptionalPort<kTestsWorldBox<C>, hls::Config<FrameRegisters<C>>> frame;
  hls::Out<ColumnRequest<C>> request;
  HLS_PORTS(job, frame, request)

  void step() {
    const Repeated<TransformJob<C>> j = job.read();
    const uint<2> column = j.index.template trunc<2>();
    const ColumnContext<C> context{j.job.packet, j.job.kind,   j.job.active,
                                   column,       j.job.extras, j.job.matrix};
    ColumnAddress<C> address = hls::concat(j.job.matrix, column);
    if constexpr (kThreeColumns<C>) {
      const bool mirror = kHasMirrors<C> && j.job.kind == TransformKind::kSecondary &&
                          j.job.extras.derived.get().pass == Derivation::kMirror;
      if (j.job.kind == TransformKind::kTriangle || mirror) {
        address = ColumnAddress<C>::from(
            (j.job.matrix + hls::concat(j.job.matrix, uint<1>(0)) + column).raw());
      }
    }
    if constexpr (kTestsWorldBox<C>) {
      if (fetches_box<C>(j.job.kind, j.job.extras)) {
        const ColumnAddress<C> first = first_box<C>(frame.get(), j.job.extras);
        address = ColumnAddress<C>::from((j.job.matrix + first).raw());
      }
    }
    request.write(ColumnRequest<C>{context, address});
  }
};

}  // namespace dynrt
