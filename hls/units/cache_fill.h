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

template <class C, class Kind>
struct CacheFill {
  using Context = typename Kind::Context;
  using Line = typename Kind::Line;
  static constexpr unsigned kItems = Kind::kItems;
  using Fill = CacheLine<C, Items<Line, kItems>, Kind::Address::kWidth>;
  using Row = CacheRow<Items<Line, kItems>, Kind::Address::kWidth - kItemBits<kItems>>;

  hls::In<Fill> fill;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<typename Kind::Reply> reply;
  PortOfEach<C::kWays, hls::RamWrite<Row, kSets<C, kItems>>> lines;
  hls::RamRead<WaitingRow<C, Context>, kCacheKeys<Kind>> waiting;
  HLS_PORTS(fill, frame, reply, lines, waiting)

  void step() {
    const Fill f = fill.read();
    const auto line = set_of<C, kItems>(f.address, frame.get());
    if constexpr (kHasWays<C>) {
      fill_way(f, line);
    } else {
      const Context context = waiting.read(f.key);
      lines.write(line, Row{false, !f.invalidate, line_of<kItems>(f.address), f.line});
      if (!f.invalidate) {
        reply.write(Kind::reply(context, f.address, item_at<kItems>(f.line, f.address)));
      }
    }
  }

 private:
  void fill_way(const Fill& f, SetNumber<C, kItems> set) {
    const InWay<C, Context> w = waiting.read(f.key);
    for (unsigned i = 0; i < C::kWays; ++i) {
      if (f.invalidate || w.way == WayNumber<C>::from(i)) {
        lines[i].write(set, Row{false, !f.invalidate, line_of<kItems>(f.address), f.line});
      }
    }
    if (!f.invalidate) {
      reply.write(Kind::reply(w.context, f.address, item_at<kItems>(f.line, f.address)));
    }
  }
};

}  // namespace dynrt
