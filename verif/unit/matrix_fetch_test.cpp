// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/matrix_fetch.h"

#include "Vmatrix_fetch.h"
#include "matrix_fetch_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<MatrixFetch<C>>&, const Run&) {}

DYNRT_COSIM(MatrixFetch, MatrixFetch<C>, matrix_fetch, setup)

}  // namespace
}  // namespace dynrt::cosim
