// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Joins an answer's head with its data, and gives the turn to the next request with the last of
// them: so data never mix, wherever they come from. A transaction is a token of data. No state.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

template <unsigned Bytes>
struct LinkAnswer {
  hls::In<NumberedLinkReply> reply;
  hls::In<LinkData<Bytes>> data;
  hls::Out<LinkPart<Bytes>> part;
  hls::Out<uint<1>> turn;
  hls::Out<LinkEvent> free;
  HLS_PORTS(reply, data, part, turn, free)

  void step() {
    const NumberedLinkReply n = reply.read();
    using Part = LinkPart<Bytes>;
    Part p;
    p.first = n.index == uint<4>(0);
    p.kind = n.job.kind;
    p.sequence = n.job.sequence;
    p.length = n.job.length;
    p.size = n.job.size;
    p.data = data.read();
    const unsigned head = p.first ? Part::kHead : 0;
    const unsigned tail = n.last ? Part::kTail : 0;
    p.repeat = Part::Count::from(p.size.raw() + head + tail - 1);
    part.write(p);
    if (n.last) {
      turn.write(uint<1>(0));
      free.write({LinkEventKind::kFree, n.job.room});
    }
  }
};

}  // namespace dynrt
