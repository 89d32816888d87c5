// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a line of a first-level cache holds: one item, or several that lie side by side in the
// memory and come in one read. A node is 8 bytes, a list entry 4, so a line of nodes has as many
// bytes as one of twice as many entries; a matrix column is a line by itself.
#pragma once

#include <array>
#include <bit>
#include <type_traits>

#include "hls/cast.h"
#include "units/memory_format.h"

namespace dynrt {

template <class C>
inline constexpr unsigned kNodesOfLine = C::kLineNodes;
template <class C>
inline constexpr unsigned kEntriesOfLine = entries_of_line(C::kLineNodes);
/// Bytes of a line, in the memory.
template <class C>
inline constexpr unsigned kNodeLineBytes = kNodesOfLine<C> * kNodeBytes;
template <class C>
inline constexpr unsigned kListLineBytes = kEntriesOfLine<C> * kEntryBytes;

/// Bits of an address that number the items of a line.
template <unsigned N>
inline constexpr unsigned kItemBits = std::bit_width(N) - 1;

/// N items; one is itself.
template <class Item, unsigned N>
using Items = std::conditional_t<N == 1, Item, std::array<Item, N>>;

/// Made of item(0) to item(N - 1).
template <unsigned N>
[[gnu::nodebug]] constexpr auto items_of(auto item) {
  if constexpr (N == 1) {
    return item(0u);
  } else {
    std::array<decltype(item(0u)), N> items;
    for (unsigned i = 0; i < N; ++i) items[i] = item(i);
    return items;
  }
}

/// The line that an address lies in.
template <unsigned N, unsigned W>
[[gnu::nodebug]] constexpr uint<W - kItemBits<N>> line_of(uint<W> address) {
  return address.template bits<W - 1, kItemBits<N>>();
}

/// The item that lies at an address.
template <unsigned N, unsigned W>
[[gnu::nodebug]] constexpr decltype(auto) item_at(const auto& items, uint<W> address) {
  if constexpr (N == 1) {
    return (items);
  } else {
    using Number = uint<kItemBits<N>>;
    auto found = items[N - 1];
    for (unsigned i = N - 1; i-- > 0;) {
      if (address.template trunc<kItemBits<N>>() == Number::from(i)) found = items[i];
    }
    return found;
  }
}

}  // namespace dynrt
