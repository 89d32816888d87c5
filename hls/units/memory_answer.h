// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Takes the line of a first-level cache out of the one of the second level, or out of the beats,
// that it lies in: nodes, list entries or a matrix column, for the cache that asked for it.
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
    const auto column_words = line_words<kColumnBytes, 1>(l);
    send_line<C>(request, line_words<kNodeLineBytes<C>, kNodesOfLine<C>>(l),
                 line_words<kListLineBytes<C>, kEntriesOfLine<C>>(l),
                 {column_words[0], column_words[1], column_words[2]}, node, list, column);
  }

 private:
  /// The line of so many bytes and items, of those of its size that were read.
  template <unsigned Bytes, unsigned N>
  static std::array<Word, Bytes / 4> line_words(const MemoryLine<C>& l) {
    constexpr unsigned kWords = Bytes / 4;
    constexpr unsigned kRead = read_bytes<C>(Bytes) / Bytes;
    using Place = uint<hls::index_width(kRead)>;
    std::array<Word, kWords> found;
    for (unsigned w = 0; w < kWords; ++w) found[w] = l.data[w];
    for (unsigned i = 1; i < kRead; ++i) {
      for (unsigned w = 0; w < kWords; ++w) {
        if (Place::from(line_of<N>(l.address).raw()) == Place::from(i)) {
          found[w] = l.data[i * kWords + w];
        }
      }
    }
    return found;
  }
};

}  // namespace dynrt
