// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/memory_lookup.h"

#include "Vmemory_lookup.h"
#include "memory_lookup_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

using Lookup = MemoryLookup<C>;
using Request = MemoryRequest<C>;

constexpr unsigned kTags = 3;  ///< lines of a set that are asked for

/// Every kind; of a second level, nodes that it may hold, some after many tries.
void shape(Request& r, Random& random) {
  r.kind = any_of<MemoryKind>(random, 3);
  if constexpr (kHasSecondLevel<C>) {
    r.invalidate = random.below(16) == 0;
    if (random.below(4) != 0) r.kind = MemoryKind::kNode;
    constexpr unsigned kNodes = kTags * kSecondSets<C> * kSecondLine<C> / kNodeBytes;
    if (random.below(8) != 0) r.address = number_below<Request::kAddressBits>(random, kNodes);
    if (random.below(8) == 0) r.tries = uint<8>::ones();
  }
}

/// A line that belongs to the set with this number.
SecondLineNumber<C> some_line(unsigned row, Random& random) {
  return SecondLineNumber<C>::from(row % kSecondSets<C> +
                                   kSecondSets<C> * static_cast<unsigned>(random.below(kTags)));
}

void setup(Bench<Lookup>& bench, const Run& /*run*/) {
  using Token = typename decltype(Lookup::request)::Data;
  bench.shape<Token>("request", []<class T>(T& r, Random& random) {
    if constexpr (requires { r.job; }) {
      shape(r.job, random);
    } else {
      shape(r, random);
    }
  });
  if constexpr (kHasSecondLevel<C>) {
    const auto likely = [](auto& row, unsigned number, Random& random) {
      row.valid = random.below(8) != 0;
      row.torn = random.below(8) == 0;
      row.line = some_line(number, random);
    };
    for (unsigned w = 0; w < kSecondWays; ++w) {
      const auto row = [likely, n = 0u](SecondRow<C>& r, Random& random) mutable {
        likely(r, n++, random);
      };
      bench.shape<SecondRow<C>>("rows_" + std::to_string(w), row);
    }
    const auto last = [likely, n = 0u](LastMiss<C>& r, Random& random) mutable {
      likely(r, n++, random);
    };
    bench.shape<LastMiss<C>>("last_miss", last);
  }
}

DYNRT_COSIM(MemoryLookup, Lookup, memory_lookup, setup)

}  // namespace
}  // namespace dynrt::cosim
