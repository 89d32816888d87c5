// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Puts the CRC into an answer and an escape before each byte that needs one. Each byte comes twice:
// the first time only an escape leaves. State: the CRC of the bytes since the flag.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

struct LinkStuff {
  hls::In<NumberedSendByte> byte;
  hls::Out<LineByte> out;
  HLS_PORTS(byte, out)

  void step() {
    const NumberedSendByte n = byte.read();
    const bool is_flag = n.job.kind == SendKind::kFlag;
    const bool is_crc = n.job.kind == SendKind::kCrc;
    const uint<8> plain = is_crc ? ~crc_.trunc<8>() : n.job.data;
    const bool escapes =
        !is_flag && (plain == uint<8>::from(kLinkFlag) || plain == uint<8>::from(kLinkEscape));
    const uint<4> repeat = uint<4>::from(kLineBitsOfByte - 1);
    if (!n.last) {
      if (escapes) out.write({repeat, uint<8>::from(kLinkEscape)});
    } else {
      out.write({repeat, escapes ? plain ^ uint<8>::from(kLinkEscaped) : plain});
      crc_ = is_flag ? kCrcStart : is_crc ? crc_.shr<8>() : crc_step(crc_, n.job.data);
    }
  }

 private:
  Crc crc_ = kCrcStart;
};

}  // namespace dynrt
