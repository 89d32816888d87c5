// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/cache_fill.h"

#include <algorithm>

#include "Vlist_fill.h"
#include "Vmatrix_fill.h"
#include "Vnode_fill.h"
#include "list_fill_ports.h"
#include "matrix_fill_ports.h"
#include "node_fill_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

template <class Kind>
using CacheFillOf = CacheFill<C, Kind>;

template <class Kind>
void setup(Bench<CacheFillOf<Kind>>& bench, const Run& run) {
  const unsigned lines = std::max(1u << (run.number == 0 ? 9 : run.number % 10), C::kWays);
  bench.template shape<FrameRegisters<C>>("frame", [lines](FrameRegisters<C>& frame, Random&) {
    frame.line_mask = Word::from(lines - 1);
  });
}

DYNRT_COSIM(NodeFill, CacheFillOf<NodeCache<C>>, node_fill, setup<NodeCache<C>>)
DYNRT_COSIM(ListFill, CacheFillOf<ListCache<C>>, list_fill, setup<ListCache<C>>)
DYNRT_COSIM(MatrixFill, CacheFillOf<MatrixCache<C>>, matrix_fill, setup<MatrixCache<C>>)

}  // namespace
}  // namespace dynrt::cosim
