// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cache, the filling half: writes the line that the memory delivers, in the way that the lookup
// chose, and answers the request that waited for it. Before a frame it invalidates line after line,
// in all ways of a set at once.
#pragma once

#include "units/cache_lookup.h"
#include "units/memory_tokens.h"

namespace dynrt {

/// The part that holds the lines.
template <class C, class Kind>
using LinesToFill =
    std::conditional_t<kHasWays<C>, WaysToFill<C, Kind>, DirectLinesToFill<C, Kind>>;

template <class C, class Kind>
struct CacheFill : LinesToFill<C, Kind> {
  using Context = typename Kind::Context;
  static constexpr unsigned kItems = Kind::kItems;
  using Fill = CacheLine<C, Items<typename Kind::Line, kItems>, Kind::Address::kWidth>;
  using Row = CacheRowOf<Kind>;

  hls::In<Fill> fill;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<typename Kind::Reply> reply;
  hls::RamRead<WaitingRow<C, Context>, kCacheKeys<Kind>> waiting;
  using PortsOfParts = hls::Parts<LinesToFill<C, Kind>>;
  HLS_PORTS(fill, frame, reply, waiting)

  void step() {
    const Fill f = fill.read();
    const auto line = set_of<C, kItems>(f.address, frame.get());
    const Context context = this->put(f, line, waiting.read(f.key));
    if (!f.invalidate) {
      reply.write(Kind::reply(context, f.address, item_at<kItems>(f.line, f.address)));
    }
  }
};

}  // namespace dynrt
