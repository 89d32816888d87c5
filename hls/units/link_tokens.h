// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The tokens between the units of the link (units/link.h).
#pragma once

#include <algorithm>
#include <array>

#include "hls/fields.h"
#include "units/link_format.h"

namespace dynrt {

using hls::uint;

inline constexpr unsigned kLinkAddressBits = 25;  ///< of a byte of the memory
inline constexpr unsigned kBusAddressBits = 26;   ///< of a byte of the registers

/// Most data of a memory read's answer.
template <unsigned Bytes>
inline constexpr unsigned kLinkReadBytes = std::min(kLinkDataBytes, kLinkReadBeats* Bytes);

using LinkLength = uint<hls::index_width(kLinkDataBytes + 1)>;
using RingPlace = uint<hls::index_width(kLinkRingBytes)>;

/// What comes to the unit that takes frames off the line.
enum class LinkEventKind : unsigned char {
  kByte,
  kBadByte,  ///< without a stop bit
  kFree,     ///< a request is answered; `value` is the room that its data took
};
struct LinkEvent {
  LinkEventKind kind = LinkEventKind::kByte;
  LinkLength value;
  HLS_FIELDS(kind, value)
};

/// A frame as it came; its data lie in the ring.
struct LinkRequest {
  bool good = false;   ///< complete and unharmed
  bool whole = false;  ///< it has as many data as its header says
  uint<8> command;
  uint<8> sequence;
  uint<16> length;
  uint<32> address;
  RingPlace start;
  LinkLength room;  ///< in the ring
  HLS_FIELDS(good, whole, command, sequence, length, address, start, room)
};

/// What is done for a request.
enum class LinkAction : unsigned char {
  kIdentify,
  kWriteMemory,
  kReadMemory,
  kWriteRegisters,
  kReadRegisters,
  kAnswer,  ///< nothing but the answer
};
struct LinkJob {
  uint<9> repeat;  ///< steps less one
  LinkAction action = LinkAction::kAnswer;
  uint<8> kind;  ///< of the answer
  uint<8> sequence;
  LinkLength length;              ///< of the answer's data
  uint<kBusAddressBits> address;  ///< of kIdentify: the sequence that is expected
  RingPlace start;
  LinkLength room;
  HLS_FIELDS(repeat, action, kind, sequence, length, address, start, room)
};
struct NumberedLinkJob {
  uint<9> index;
  bool last = false;
  LinkJob job;
  HLS_FIELDS(index, last, job)
};

/// Towards the memory: a beat to write, of whose 16-bit halves those count that the mask names.
template <unsigned Bytes>
using BeatHalves = std::array<uint<16>, Bytes / 2>;
template <unsigned Bytes>
struct LinkWrite {
  uint<kLinkAddressBits> address;  ///< of the beat
  BeatHalves<Bytes> data;          ///< from the lowest address on
  uint<Bytes / 2> mask;
  bool last = false;  ///< of its request
  HLS_FIELDS(address, data, mask, last)
};
struct LinkRead {
  uint<kLinkAddressBits> address;  ///< of the first beat
  uint<4> last;                    ///< beats less one
  HLS_FIELDS(address, last)
};
template <unsigned Bytes>
struct LinkBeat {
  BeatHalves<Bytes> data;
  bool last = false;  ///< of its read
  HLS_FIELDS(data, last)
};
/// Towards the registers; each read is answered by a word, in order.
struct BusAccess {
  bool write = false;
  uint<kBusAddressBits> address;
  uint<32> data;
  HLS_FIELDS(write, address, data)
};

/// An answer: how often data come for it, less one, and how many bytes each time.
struct LinkReply {
  uint<4> repeat;
  uint<8> kind;
  uint<8> sequence;
  LinkLength length;
  uint<6> size;
  LinkLength room;  ///< that the request took in the ring
  HLS_FIELDS(repeat, kind, sequence, length, size, room)
};
struct NumberedLinkReply {
  uint<4> index;
  bool last = false;
  LinkReply job;
  HLS_FIELDS(index, last, job)
};
/// Data of an answer come in at most so many tokens.
inline constexpr unsigned kReplyTokens = 16;
static_assert(kLinkReadBeats <= kReplyTokens && kLinkReadWords <= kReplyTokens &&
              kLinkIdentityWords <= kReplyTokens);
template <unsigned Bytes>
inline constexpr unsigned kReplyBytes = std::max(Bytes, 4u);
template <unsigned Bytes>
struct LinkData {
  std::array<uint<8>, kReplyBytes<Bytes>> bytes;
  HLS_FIELDS(bytes)
};

/// A part of an answer: its head, data, its end.
template <unsigned Bytes>
struct LinkPart {
  static constexpr unsigned kHead = 1 + kLinkAnswerBytes;  ///< the flag and the header
  static constexpr unsigned kTail = kLinkCrcBytes + 1;
  using Count = uint<hls::index_width(kHead + kReplyBytes<Bytes> + kTail)>;
  Count repeat;  ///< bytes less one
  bool first = false;
  uint<8> kind;
  uint<8> sequence;
  LinkLength length;
  uint<6> size;
  LinkData<Bytes> data;
  HLS_FIELDS(repeat, first, kind, sequence, length, size, data)
};
template <unsigned Bytes>
struct NumberedLinkPart {
  typename LinkPart<Bytes>::Count index;
  bool last = false;
  LinkPart<Bytes> job;
  HLS_FIELDS(index, last, job)
};

/// A byte that is sent, before escapes.
enum class SendKind : unsigned char { kFlag, kData, kCrc };
struct SendByte {
  uint<1> repeat;  ///< an escape may be before it
  SendKind kind = SendKind::kFlag;
  uint<8> data;
  HLS_FIELDS(repeat, kind, data)
};
struct NumberedSendByte {
  uint<1> index;
  bool last = false;
  SendByte job;
  HLS_FIELDS(index, last, job)
};

/// A byte on the line: a start bit, eight of data, a stop bit.
struct LineByte {
  uint<4> repeat;  ///< bits less one
  uint<8> data;
  HLS_FIELDS(repeat, data)
};
struct NumberedLineByte {
  uint<4> index;
  bool last = false;
  LineByte job;
  HLS_FIELDS(index, last, job)
};

}  // namespace dynrt

template <>
inline constexpr unsigned hls::enum_width<dynrt::LinkEventKind> = 2;
template <>
inline constexpr unsigned hls::enum_width<dynrt::LinkAction> = 3;
template <>
inline constexpr unsigned hls::enum_width<dynrt::SendKind> = 2;
