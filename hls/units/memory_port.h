// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one port between the caches and whatever memory holds the scene: reads with an id, many in
// flight, answered in any order, the beats of an answer one after another; bursts of writes, which
// nothing waits for; and the second level of cache that may stand before it, shared by all
// pipelines. What a memory does with a read is its own affair: an id says whose it is, so the core
// needs no order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include "hls/cast.h"
#include "units/memory_tokens.h"

namespace dynrt {

/// Whether the scene lies behind the port, and not in banks of SRAM.
template <class C>
inline constexpr bool kHasPort = C::kMemory == MemoryPath::kPort;
/// Bytes that the port moves in a clock: a beat.
template <class C>
inline constexpr unsigned kBeatBytes = C::kPortBytes;

/// Lines of the second level, their bytes, and the sets of ways that they lie in.
inline constexpr unsigned kSecondWays = 4;
template <class C>
inline constexpr unsigned kSecondLine = second_line_bytes(C::kLineNodes, C::kPortBytes);
template <class C>
inline constexpr unsigned kSecondSets =
    std::max(1u, C::kSecondLevel * 1024 / kSecondLine<C> / kSecondWays);
template <class C>
using SecondSet = uint<hls::index_width(kSecondSets<C>)>;
/// The number of a line in the memory.
template <class C>
inline constexpr unsigned kSecondLineBits = std::countr_zero(kSecondLine<C>);
template <class C>
using SecondLineNumber = uint<kPortAddressBits - kSecondLineBits<C>>;

/// A value for each kind of item; the one of `kind`.
template <class T>
constexpr T of_kind(MemoryKind kind, const T& node, const T& entry, const T& column) {
  return kind == MemoryKind::kNode ? node : kind == MemoryKind::kList ? entry : column;
}

/// Bytes that a read brings for a line of the first level: a line of the second, or the beats that
/// it lies in.
template <class C>
constexpr unsigned read_bytes(unsigned line_bytes) {
  return kHasSecondLevel<C> ? kSecondLine<C> : std::max(line_bytes, kBeatBytes<C>);
}
/// Beats of a read, less one. The last word of a column's place holds nothing and is left out.
template <class C>
constexpr unsigned last_beat(MemoryKind kind) {
  const unsigned used = of_kind(kind, kNodeLineBytes<C>, kListLineBytes<C>, 12u);
  return (std::max(kHasSecondLevel<C> ? kSecondLine<C> : used, kBeatBytes<C>) - 1) / kBeatBytes<C>;
}
/// The bytes of the longest read, its beats and its words; those of a shorter one are the first.
template <class C>
inline constexpr unsigned kReadBytes =
    std::max(read_bytes<C>(kColumnBytes), read_bytes<C>(kNodeLineBytes<C>));
template <class C>
inline constexpr unsigned kReadBeats = kReadBytes<C> / kBeatBytes<C>;
template <class C>
using ReadWords = std::array<Word, kReadBytes<C> / 4>;

/// Whose a read is: a cache, and the request within it.
template <class C>
struct PortId {
  MemoryKind kind = MemoryKind::kNode;
  uint<2 + PacketId<C>::kWidth> key;
  [[no_unique_address]] PipelineNumber<C> pipeline{};
  HLS_FIELDS(kind, key, pipeline)
};
template <class C>
PortId<C> port_id(const MemoryRequest<C>& request) {
  return {request.kind, request.key, request.pipeline};
}
template <class C>
inline constexpr unsigned kPortIds = 1u << hls::bit_width_of<PortId<C>>();

using PortAddress = uint<kPortAddressBits>;  ///< of a byte

template <class C>
struct PortRead {
  PortId<C> id;
  PortAddress address;  ///< of the first beat
  uint<4> last;         ///< beats less one
  HLS_FIELDS(id, address, last)
};
/// From the lowest address on.
template <class C>
using BeatData = std::array<uint<16>, kBeatBytes<C> / 2>;
template <class C>
struct PortBeat {
  PortId<C> id;
  BeatData<C> data;
  bool last = false;  ///< of its read
  HLS_FIELDS(id, data, last)
};

/// A beat of a burst of pixels or hit records, whose beats come one after another.
template <class C>
struct PortWrite {
  uint<kMemoryAddressBits> address;  ///< of its first byte
  BeatData<C> data;
  uint<kBeatBytes<C> / 2> mask;  ///< the halves to be written; it may be none
  uint<3> left;                  ///< beats of its burst that follow
  HLS_FIELDS(address, data, mask, left)

  static constexpr uint<kMemoryAddressBits> within_beat() { return kBeatBytes<C> - 1; }
};

/// What a read has brought; or, to the second level, the order to invalidate a set.
template <class C>
struct PortLine {
  [[no_unique_address]] UsualField<kHasSecondLevel<C>, bool> invalidate{};
  [[no_unique_address]] UsualField<kHasSecondLevel<C>, SecondSet<C>> set{};
  PortId<C> id;
  ReadWords<C> data;
  HLS_FIELDS(invalidate, set, id, data)
};

/// What is kept of a read until its answer comes: the item's address, and the way of the second
/// level that its line goes to.
template <class C>
struct ReadInFlight {
  uint<MemoryRequest<C>::kAddressBits> address;
  [[no_unique_address]] UsualField<kHasSecondLevel<C>, uint<2>> way{};
  HLS_FIELDS(address, way)
};

/// The line, or the beats, that an item lies in; for its cache.
template <class C>
struct MemoryLine {
  PortId<C> id;
  uint<MemoryRequest<C>::kAddressBits> address;
  ReadWords<C> data;
  HLS_FIELDS(id, address, data)
};

/// A row of one way of the second level.
template <class C>
struct SecondRow {
  bool torn = false;  ///< hls::Hazard::kTorn
  bool valid = false;
  SecondLineNumber<C> line;
  std::array<Word, kSecondLine<C> / 4> data;
  HLS_FIELDS(torn, valid, line, data)
};
/// The last miss of a set: its line may be on its way.
template <class C>
struct LastMiss {
  bool torn = false;  ///< hls::Hazard::kTorn
  bool valid = false;
  SecondLineNumber<C> line;
  uint<2> way;
  HLS_FIELDS(torn, valid, line, way)
};

/// Where an item begins in the memory (units/memory_format.h).
template <class C>
constexpr PortAddress byte_of(MemoryKind kind, uint<MemoryRequest<C>::kAddressBits> address) {
  const auto number = address.template zext<kAddressBits>();
  return of_kind<PortAddress>(kind, hls::concat(hls::concat(uint<2>(0b00), number), uint<3>(0)),
                              hls::concat(hls::concat(uint<3>(0b010), number), uint<2>(0)),
                              hls::concat(hls::concat(uint<1>(1), number), uint<4>(0)));
}
/// The line of the second level that it lies in.
template <class C>
constexpr SecondLineNumber<C> second_line_of(MemoryKind kind,
                                             uint<MemoryRequest<C>::kAddressBits> address) {
  return byte_of<C>(kind, address).template bits<kPortAddressBits - 1, kSecondLineBits<C>>();
}
static_assert(kNodeBytes == 8 && kEntryBytes == 4 && kColumnBytes == 16);
static_assert(kEntriesAt == 0b010u << 21 && kColumnsAt == 1u << 23 && kPortAddressBits == 24);

}  // namespace dynrt
