// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Takes a node, a list entry or a matrix column out of the line that it lies in, for the cache that
// asked for it.
#pragma once

#include "units/memory_interface.h"
#include "units/memory_port.h"

namespace dynrt {

template <class C>
struct MemoryAnswer {
  using Real = typename C::Real;
  static_assert(!kHasPort<C> || SceneWord<Real>::kWidth == Word::kWidth,
                "a word of a memory behind the port has 32 bits");

  hls::In<MemoryLine<C>> line;
  PortOfEach<kPipelines<C>, hls::Out<NodeLine<C>>> node;
  PortOfEach<kPipelines<C>, hls::Out<ListLine<C>>> list;
  PortOfEach<kPipelines<C>, hls::Out<ColumnLine<C>>> column;
  HLS_PORTS(line, node, list, column)

  void step() {
    const MemoryLine<C> l = line.read();
    const MemoryRequest<C> request{
        .kind = l.id.kind, .key = l.id.key, .address = l.address, .pipeline = l.id.pipeline};
    const auto node_words = item<kNodeBytes>(l);
    const auto column_words = item<kColumnBytes>(l);
    const bool is_column = l.id.kind == MemoryKind::kColumn;
    send_line<C>(
        request,
        {is_column ? column_words[0] : node_words[0], is_column ? column_words[1] : node_words[1],
         is_column ? column_words[2] : item<kEntryBytes>(l)[0]},
        node, list, column);
  }

 private:
  /// The item, of those of its size in the line.
  template <unsigned Bytes>
  static std::array<Word, Bytes / 4> item(const MemoryLine<C>& l) {
    constexpr unsigned kWords = Bytes / 4;
    constexpr unsigned kItems = read_bytes<C>(Bytes) / Bytes;
    using Place = uint<hls::index_width(kItems)>;
    std::array<Word, kWords> found;
    for (unsigned w = 0; w < kWords; ++w) found[w] = l.data[w];
    for (unsigned i = 1; i < kItems; ++i) {
      for (unsigned w = 0; w < kWords; ++w) {
        if (Place::from(l.address.raw()) == Place::from(i)) found[w] = l.data[i * kWords + w];
      }
    }
    return found;
  }
};

}  // namespace dynrt
