// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/cache_lookup.h"

#include <algorithm>
#include <string>

#include "Vlist_lookup.h"
#include "Vmatrix_lookup.h"
#include "Vnode_lookup.h"
#include "list_lookup_ports.h"
#include "matrix_lookup_ports.h"
#include "node_lookup_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

template <class Kind>
using CacheLookupOf = CacheLookup<C, Kind>;

/// The lines hold requested addresses, and sometimes one that belongs to another line.
template <class Kind>
void setup(Bench<CacheLookupOf<Kind>>& bench, const Run& run) {
  using Request = typename CacheLookup<C, Kind>::Request;
  using Row = typename CacheLookup<C, Kind>::Row;
  const unsigned lines = std::max(1u << (run.number == 0 ? 9 : run.number % 10), C::kWays);
  const unsigned sets = lines / C::kWays;
  bench.template shape<FrameRegisters<C>>("frame", [lines](FrameRegisters<C>& frame, Random&) {
    frame.line_mask = Word::from(lines - 1);
  });
  bench.template shape<Request>("request", [lines](Request& r, Random& random) {
    if (random.below(8) != 0) r.address = number_below<kAddressBits>(random, 3 * lines);
  });
  for (unsigned way = 0; way < C::kWays; ++way) {
    const std::string port = kHasWays<C> ? "lines_" + std::to_string(way) : "lines";
    bench.template shape<Row>(port, [=, number = 0u](Row& row, Random& random) mutable {
      const unsigned row_number = number++;
      // A cache may have one line.
      row.valid = row_number == 0 || random.below(8) != 0;
      row.torn = row_number != 0 && random.below(8) == 0;
      row.tag = Address::from(row_number % sets + sets * random.below(3 * C::kWays));
      if (random.below(8) == 0) row.tag = number_below<kAddressBits>(random, 3 * lines);
    });
  }
}

DYNRT_COSIM(NodeLookup, CacheLookupOf<NodeCache<C>>, node_lookup, setup<NodeCache<C>>)
DYNRT_COSIM(ListLookup, CacheLookupOf<ListCache<C>>, list_lookup, setup<ListCache<C>>)
DYNRT_COSIM(MatrixLookup, CacheLookupOf<MatrixCache<C>>, matrix_lookup, setup<MatrixCache<C>>)

}  // namespace
}  // namespace dynrt::cosim
