// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cache, the looking half (thesis chapter 7): up to C::kLines items in C::kWays ways, in lines of
// one item or several (units/line_items.h), tagged with the whole address so that the number of
// lines may change between frames. A hit is answered at
// once; a miss goes to the memory and its context is stored, so later requests do not wait.
// CacheFill is the other half and owns the writing port of the lines. A line that is replaced while
// it is looked up is a miss. Where an address may lie is a part: in one line (units/direct_lines.h)
// or in one of several ways (units/cache_ways.h).
#pragma once

#include "units/cache_ways.h"
#include "units/direct_lines.h"
#include "units/frame.h"
#include "units/memory_tokens.h"
#include "units/port_of_each.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

/// The three caches: an item and how many a line has, the context of a request, its key in the
/// memory, and whether the reply is known without the line.
template <class C>
struct NodeCache {
  using Context = StepContext<C>;
  using Address = NodeAddress<C>;
  using Line = CoreNode<C>;
  static constexpr unsigned kItems = kNodesOfLine<C>;
  using Reply = Step<C>;
  static constexpr MemoryKind kKind = MemoryKind::kNode;
  static constexpr uint<2 + PacketId<C>::kWidth> key(const Context& c) { return c.packet; }
  static constexpr bool is_known(Address address) { return is_list<C>(address); }
  /// A pointer to a list stands for the leaf.
  static constexpr Reply reply(const Context& c, Address address, const Line& line) {
    Reply step{c, line};
    if (is_known(address)) {
      step.node.kind = NodeKind::kLeaf;
      step.node.left = list_address<C>(address);
    }
    return step;
  }
};
template <class C>
struct ListCache {
  using Context = ListContext<C>;
  using Address = NodeAddress<C>;
  using Line = CoreListEntry<C>;
  static constexpr unsigned kItems = kEntriesOfLine<C>;
  using Reply = MailboxEntry<C>;
  static constexpr MemoryKind kKind = MemoryKind::kList;
  static constexpr uint<2 + PacketId<C>::kWidth> key(const Context& c) { return c.packet; }
  static constexpr bool is_known(Address) { return false; }
  static constexpr Reply reply(const Context& c, Address, const Line& line) {
    return {c.packet, c.level, false, c.active.get(), {}, line};
  }
};
template <class C>
struct MatrixCache {
  using Context = ColumnContext<C>;
  using Address = ColumnAddress<C>;
  using Line = MatrixColumn<typename C::Real>;
  static constexpr unsigned kItems = 1;
  using Reply = ColumnReply<C>;
  static constexpr MemoryKind kKind = MemoryKind::kColumn;
  static constexpr uint<2 + PacketId<C>::kWidth> key(const Context& c) {
    return hls::concat(c.column, c.packet);
  }
  static constexpr bool is_known(Address) { return false; }
  static constexpr Reply reply(const Context& c, Address address, const Line& line) {
    return {c, address, line};
  }
};

template <class Kind>
inline constexpr unsigned kCacheKeys = 1u << decltype(Kind::key({}))::kWidth;

template <class C, class Context>
using WaitingRow = std::conditional_t<kHasWays<C>, InWay<C, Context>, Context>;
/// The part that holds the lines.
template <class C, class Kind>
using LinesToRead =
    std::conditional_t<kHasWays<C>, WaysToRead<C, Kind>, DirectLinesToRead<C, Kind>>;

template <class C, class Kind>
struct CacheLookup : LinesToRead<C, Kind>, PipelineOf<C> {
  using Context = typename Kind::Context;
  using Lines = LinesToRead<C, Kind>;
  using Line = typename Kind::Line;
  using Request = CacheRequest<Context, Kind::Address::kWidth>;
  static constexpr unsigned kItems = Kind::kItems;
  using Row = CacheRowOf<Kind>;
  static constexpr unsigned kRoom = kRoomForBursts<C>;

  hls::In<Request> request;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<typename Kind::Reply> reply;
  hls::Out<MemoryRequest<C>> miss;
  hls::RamWrite<WaitingRow<C, Context>, kCacheKeys<Kind>> waiting;
  using PortsOfParts = hls::Parts<Lines, PipelineOf<C>>;
  HLS_PORTS(request, frame, reply, miss, waiting)

  void step() {
    const Request r = request.read();
    const auto line = set_of<C, kItems>(r.address, frame.get());
    Line item;
    WaitingRow<C, Context> waits;
    const bool hit = this->look(r, line, item, waits);
    // Only who misses reads it; written always, it need not wait for the comparison.
    waiting.write(Kind::key(r.context), waits);
    if (Kind::is_known(r.address) || hit) {
      reply.write(Kind::reply(r.context, r.address, item));
    } else {
      ask_memory(r);
    }
  }

 private:
  [[gnu::nodebug]] void ask_memory(const Request& r) {
    miss.write(MemoryRequest<C>{.kind = Kind::kKind,
                                .key = Kind::key(r.context),
                                .address = r.address,
                                .pipeline = this->number()});
  }
};

}  // namespace dynrt
