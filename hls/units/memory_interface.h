// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Memory interface: serves the misses of the three caches from SRAM banks 0 to 2, one a clock: a
// node from banks 0 and 1, a list entry from bank 2, a matrix column from all three (thesis chapter
// 7). To a core for a slower memory each takes several clocks.
#pragma once

#include <type_traits>

#include "hls/cast.h"
#include "units/memory_tokens.h"
#include "units/repeated.h"

namespace dynrt {

/// The value in the lowest bits.
template <class T, unsigned W>
T lowest(uint<W> bits) {
  return hls::from_bits<T>(bits.template trunc<hls::bit_width_of<T>()>());
}

/// Sends a line to the cache that asked for it, which is made of these words.
template <class C, std::size_t NodeWords, std::size_t Entries>
void send_line(const MemoryRequest<C>& r,
               const std::array<SceneWord<typename C::Real>, NodeWords>& node_words,
               const std::array<SceneWord<typename C::Real>, Entries>& list_words,
               const std::array<SceneWord<typename C::Real>, 3>& column_words, auto& node,
               auto& list, auto& column) {
  using Real = typename C::Real;
  const auto narrow = [](const Node<Real>& n) {
    return CoreNode<C>{n.kind, n.split, n.left.template trunc<C::kAddressBits>(),
                       n.right.template trunc<C::kAddressBits>()};
  };
  switch (r.kind) {
    case MemoryKind::kNode:
      write_to<kPipelines<C>>(node, r.pipeline.get(),
                              NodeLine<C>{false, r.key, r.address.template trunc<C::kAddressBits>(),
                                          items_of<kNodesOfLine<C>>([&](unsigned i) {
                                            return narrow(lowest<Node<Real>>(hls::concat(
                                                node_words[2 * i + 1], node_words[2 * i])));
                                          })});
      break;
    case MemoryKind::kList:
      write_to<kPipelines<C>>(list, r.pipeline.get(),
                              ListLine<C>{false, r.key, r.address.template trunc<C::kAddressBits>(),
                                          items_of<kEntriesOfLine<C>>([&](unsigned i) {
                                            return core_entry<C>(lowest<ListEntry>(list_words[i]));
                                          })});
      break;
    case MemoryKind::kColumn:
      write_to<kPipelines<C>>(
          column, r.pipeline.get(),
          ColumnLine<C>{false, r.key, r.address.template trunc<ColumnAddress<C>::kWidth>(),
                        MatrixColumn<Real>{{lowest<MatrixWord<Real>>(column_words[0]),
                                            lowest<MatrixWord<Real>>(column_words[1]),
                                            lowest<MatrixWord<Real>>(column_words[2])}}});
      break;
  }
}

template <class C>
struct MemoryInterface {
  using Real = typename C::Real;
  using Request = MemoryRequest<C>;
  hls::In<std::conditional_t<kSlowMemory<C>, Repeated<Request>, Request>> request;
  PortOfEach<kPipelines<C>, hls::Out<NodeLine<C>>> node;
  PortOfEach<kPipelines<C>, hls::Out<ListLine<C>>> list;
  PortOfEach<kPipelines<C>, hls::Out<ColumnLine<C>>> column;
  hls::RamRead<SceneWord<Real>, kBankWords, kSramLatency> bank[kSceneBanks];
  HLS_PORTS(request, node, list, column, bank)

  void step() {
    const auto r = request.read();
    if constexpr (kSlowMemory<C>) {
      if (r.last) serve(r.job);
    } else {
      serve(r);
    }
  }

 private:
  void serve(const Request& r) {
    const bool is_column = r.kind == MemoryKind::kColumn;
    const uint<20> word = hls::concat(uint<1>(is_column), r.address.template zext<kAddressBits>());
    const std::array<SceneWord<Real>, kSceneBanks> data{bank[0].read(word), bank[1].read(word),
                                                        bank[2].read(word)};
    using Words = SceneWord<Real>;
    send_line<C>(r, std::array<Words, 2>{data[0], data[1]}, std::array<Words, 1>{data[2]}, data,
                 node, list, column);
  }
};

}  // namespace dynrt
