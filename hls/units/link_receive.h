// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Finds the frames among the bytes of the line, and keeps their data in a ring until they are
// answered. Only a frame whose CRC is right is passed on as good, so that a byte that was lost or
// changed never reaches memory or registers. A transaction is a byte, or the room of a request that
// is answered. It never waits: a frame for which there is no room is passed on as a bad one, or
// dropped. State: the frame's header, length and CRC, the free part of the ring, now and when the
// frame began.
#pragma once

#include "hls/ports.h"
#include "units/link_tokens.h"

namespace dynrt {

struct LinkReceive {
  hls::In<LinkEvent> event;
  hls::RamWrite<uint<8>, kLinkRingBytes> ring;
  hls::Out<LinkRequest> request;
  hls::Out<uint<1>> turn;  ///< the first; the others come from answers
  HLS_PORTS(event, ring, request, turn)

  void step() {
    const LinkEvent e = event.read();
    if (!begun_) turn.write(uint<1>(0));
    begun_ = true;
    const uint<8> byte = e.value.template trunc<8>();
    const bool is_byte = e.kind == LinkEventKind::kByte;
    const bool is_bad = e.kind == LinkEventKind::kBadByte;
    const bool is_flag = is_byte && byte == uint<8>::from(kLinkFlag);
    const bool is_escape = is_byte && byte == uint<8>::from(kLinkEscape);
    const bool takes = is_byte && !is_flag && !is_escape;
    const auto room = room_;  // which a byte does not change
    if (e.kind == LinkEventKind::kFree) {
      room_ = (room_ + e.value).template trunc<kRoomBits>();
      places_ = hls::next(places_);
    }
    if (is_flag && count_ != Count(0)) pass_on();
    if (takes) take(escaped_ ? byte ^ uint<8>::from(kLinkEscaped) : byte);
    // Of the frame, if it ends behind this byte.
    if (takes) fits_ = count_ < room_of_frame_ + Count::from(kFixed);
    if ((takes || is_bad) && count_ == Count(0)) room_of_frame_ = room;
    if (is_byte) escaped_ = is_escape;
    // A frame that is too long is a bad one; its count wraps.
    bad_ = !is_flag && (bad_ || is_bad || (takes && count_ == Count::ones()));
    const auto counted = (count_ + uint<1>(takes || is_bad)).template trunc<Count::kWidth>();
    count_ = is_flag ? Count(0) : counted;
    if (is_flag) crc_ = kCrcStart;
  }

 private:
  static constexpr unsigned kFixed = kLinkHeaderBytes + kLinkCrcBytes;
  using Count = uint<hls::index_width(kFixed + kLinkDataBytes + 2)>;
  static constexpr unsigned kRoomBits = hls::index_width(kLinkRingBytes + 1);

  void take(uint<8> byte) {
    const bool in_header = count_ < Count::from(kLinkHeaderBytes);
    // The data, and the CRC behind them, which nobody reads.
    const auto behind = Count::from(count_.raw() - kLinkHeaderBytes);
    if (!in_header && behind < room_of_frame_) {
      ring.write((start_ + behind).template trunc<RingPlace::kWidth>(), byte);
    }
    if (in_header) header_ = hls::concat(byte, header_.template bits<63, 8>());
    crc_ = crc_step(crc_, byte);
  }

  void pass_on() {
    if (places_ == Places(0)) return;
    LinkRequest r;
    r.command = header_.template bits<7, 0>();
    r.sequence = header_.template bits<15, 8>();
    r.length = header_.template bits<31, 16>();
    r.address = header_.template bits<63, 32>();
    r.start = start_;
    const auto data = Count::from(count_.raw() - kFixed);
    const bool unharmed =
        !bad_ && !escaped_ && crc_ == kCrcResidue && !(count_ < Count::from(kFixed));
    r.good = unharmed && fits_;
    r.whole = data == (is_write(r.command) ? r.length : uint<16>(0));
    if (r.good) {
      r.room = data.template trunc<LinkLength::kWidth>();
      room_ = uint<kRoomBits>::of_raw(room_.raw() - data.raw());
      start_ = (start_ + data).template trunc<RingPlace::kWidth>();
    }
    places_ = Places::of_raw(places_.raw() - Places(1).raw());
    request.write(r);
  }

  static bool is_write(uint<8> command) {
    return command == uint<8>::from(static_cast<unsigned>(LinkCommand::kWriteMemory)) ||
           command == uint<8>::from(static_cast<unsigned>(LinkCommand::kWriteRegisters));
  }

  using Places = uint<hls::index_width(kLinkWaiting + 1)>;

  bool begun_ = false;
  bool escaped_ = false;
  bool bad_ = true;  ///< what comes before the first flag is no frame
  Count count_;      ///< bytes of the frame so far
  uint<64> header_;
  Crc crc_ = kCrcStart;
  RingPlace start_;                                              ///< of the frame's data
  uint<kRoomBits> room_ = uint<kRoomBits>(int{kLinkRingBytes});  ///< free bytes of the ring
  /// When the frame began. What is freed later is not for it: its first bytes may have found no
  /// room.
  uint<kRoomBits> room_of_frame_ = uint<kRoomBits>(int{kLinkRingBytes});
  bool fits_ = false;                          ///< the data so far, into that room
  Places places_ = Places(int{kLinkWaiting});  ///< requests that may still wait
};

}  // namespace dynrt
