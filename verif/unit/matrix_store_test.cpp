// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/matrix_store.h"

#include "Vmatrix_store.h"
#include "matrix_store_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// Four columns of any number make a matrix; those of one packet may come one after the other.
void setup(Bench<MatrixStore<C>>& bench, const Run&) {
  using Reply = ColumnReply<C>;
  bench.shape<Reply>("reply", [](Reply& r, Random& random) {
    r.context.kind = any_of<TransformKind>(random, kTestsWorldBox<C> ? 4 : 3);
  });
}

DYNRT_COSIM(MatrixStore, MatrixStore<C>, matrix_store, setup)

}  // namespace
}  // namespace dynrt::cosim
