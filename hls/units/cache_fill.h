// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Direct-mapped cache, the filling half: writes the line that the memory delivers and answers the
// request that waited for it; before a frame it invalidates line after line.
#pragma once

#include "units/cache_lookup.h"
#include "units/memory_tokens.h"

namespace dynrt {

template <class C, class Kind>
struct CacheFill {
  using Context = typename Kind::Context;
  using Line = typename Kind::Line;
  using Fill = CacheLine<C, Line, Kind::Address::kWidth>;
  using Row = CacheRow<Line, Kind::Address::kWidth>;

  hls::In<Fill> fill;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<typename Kind::Reply> reply;
  hls::RamWrite<Row, C::kLines> lines;
  hls::RamRead<Context, kCacheKeys<Kind>> waiting;
  HLS_PORTS(fill, frame, reply, lines, waiting)

  void step() {
    const Fill f = fill.read();
    using Index = uint<hls::index_width(C::kLines)>;
    const Index line = Index::from((f.address.raw() & frame.get().line_mask.raw()));
    const Context context = waiting.read(f.key);
    lines.write(line, Row{false, !f.invalidate, f.address, f.line});
    if (!f.invalidate) reply.write(Kind::reply(context, f.address, f.line));
  }
};

}  // namespace dynrt
