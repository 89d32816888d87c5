// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Memory interface: serves the misses of the three caches from SRAM banks 0 to 2, one a clock: a
// node from banks 0 and 1, a list entry from bank 2, a matrix column from all three (thesis chapter
// 7).
#pragma once

#include "hls/cast.h"
#include "units/tokens.h"

namespace dynrt {

template <class C>
struct MemoryInterface {
  hls::In<MemoryRequest<C>> request;
  hls::Out<CacheLine<C, Node>> node;
  hls::Out<CacheLine<C, ListEntry>> list;
  hls::Out<CacheLine<C, MatrixColumn>> column;
  hls::RamRead<Word, kBankWords, C::kSramLatency> bank[kSceneBanks];
  HLS_PORTS(request, node, list, column, bank[0], bank[1], bank[2])

  void step() {
    const MemoryRequest<C> r = request.read();
    const bool is_column = r.kind == MemoryKind::kColumn;
    const uint<20> word = hls::concat(uint<1>(is_column), r.address);
    const std::array<Word, kSceneBanks> data{bank[0].read(word), bank[1].read(word),
                                             bank[2].read(word)};
    switch (r.kind) {
      case MemoryKind::kNode:
        node.write({false, r.key, r.address, hls::from_bits<Node>(hls::concat(data[1], data[0]))});
        break;
      case MemoryKind::kList:
        list.write({false, r.key, r.address, hls::from_bits<ListEntry>(data[2])});
        break;
      case MemoryKind::kColumn:
        column.write(
            {false, r.key, r.address,
             hls::from_bits<MatrixColumn>(hls::concat(data[2], hls::concat(data[1], data[0])))});
        break;
    }
  }
};

}  // namespace dynrt
