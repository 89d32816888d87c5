// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Matrix fetch: asks the matrix cache for the four columns of an object's, a triangle's or the
// camera's matrix, one a clock (the reading half of the thesis's load matrix unit, 6.1.3).
#pragma once

#include "units/tokens.h"

namespace dynrt {

template <class C>
struct MatrixFetch {
  hls::In<Repeated<TransformJob<C>>> job;
  hls::Out<CacheRequest<ColumnContext<C>>> request;
  HLS_PORTS(job, request)

  void step() {
    const Repeated<TransformJob<C>> j = job.read();
    const uint<2> column = j.index.template trunc<2>();
    const ColumnContext<C> context{j.job.packet, j.job.kind, j.job.active, column, j.job.extras};
    request.write(CacheRequest<ColumnContext<C>>{context, hls::concat(j.job.matrix, column)});
  }
};

}  // namespace dynrt
