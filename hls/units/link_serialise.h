// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Takes an answer apart into bytes. A transaction is a byte. No state.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

template <unsigned Bytes>
struct LinkSerialise {
  hls::In<NumberedLinkPart<Bytes>> part;
  hls::Out<SendByte> byte;
  HLS_PORTS(part, byte)

  void step() {
    const NumberedLinkPart<Bytes> n = part.read();
    const LinkPart<Bytes>& p = n.job;
    using Part = LinkPart<Bytes>;
    constexpr unsigned kPlaceBits = Part::Count::kWidth + 1;
    using Place = uint<kPlaceBits>;
    const Place place = n.index + Part::Count::from(p.first ? 0 : Part::kHead);
    const auto end = (p.size + Place::from(Part::kHead)).template trunc<kPlaceBits>();
    const auto crc_end = (end + Place::from(kLinkCrcBytes)).template trunc<kPlaceBits>();
    SendByte b;
    b.repeat = uint<1>(1);
    b.kind = SendKind::kData;
    if (place == Place(0) || !(place < crc_end)) {
      b.kind = SendKind::kFlag;
      b.repeat = uint<1>(0);
      b.data = uint<8>::from(kLinkFlag);
    } else if (place == Place(1)) {
      b.data = p.kind;
    } else if (place == Place(2)) {
      b.data = p.sequence;
    } else if (place == Place(3)) {
      b.data = p.length.template trunc<8>();
    } else if (place == Place(4)) {
      b.data = p.length.template bits<LinkLength::kWidth - 1, 8>();
    } else if (place < end) {
      b.data = data_at(p.data, place);
    } else {
      b.kind = SendKind::kCrc;
    }
    byte.write(b);
  }

 private:
  template <class Place>
  static uint<8> data_at(const LinkData<Bytes>& data, Place place) {
    uint<8> found = data.bytes[0];
    for (unsigned i = 1; i < kReplyBytes<Bytes>; ++i) {
      if (place == Place::from(LinkPart<Bytes>::kHead + i)) found = data.bytes[i];
    }
    return found;
  }
};

}  // namespace dynrt
