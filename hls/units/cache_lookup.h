// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Cache, the looking half (thesis chapter 7): up to C::kLines items in C::kWays ways, in lines of
// one item or several (units/line_items.h), tagged with the whole address so that the number of
// lines may change between frames. A hit is answered at
// once; a miss goes to the memory and its context is stored, so later requests do not wait.
// CacheFill is the other half and owns the writing port of the lines. A line that is replaced while
// it is looked up is a miss. Where there are ways the lookup chooses the one that a miss replaces.
#pragma once

#include "units/cache_ways.h"
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

template <class C, class Kind>
struct CacheLookup : PipelineOf<C> {
  using Context = typename Kind::Context;
  using Line = typename Kind::Line;
  using Request = CacheRequest<Context, Kind::Address::kWidth>;
  static constexpr unsigned kItems = Kind::kItems;
  using Row = CacheRow<Items<Line, kItems>, Kind::Address::kWidth - kItemBits<kItems>>;
  using Use = UseRow<C>;
  static constexpr unsigned kRoom = kRoomForBursts<C>;

  hls::In<Request> request;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<typename Kind::Reply> reply;
  hls::Out<MemoryRequest<C>> miss;
  PortOfEach<C::kWays, hls::RamRead<Row, kSets<C, kItems>>> lines;
  hls::RamWrite<WaitingRow<C, Context>, kCacheKeys<Kind>> waiting;
  hls::OptionalPort<kHasWays<C>, hls::RamRead<Use, kSets<C, kItems>>> use;
  hls::OptionalPort<kHasWays<C>, hls::RamWrite<Use, kSets<C, kItems>>> used;
  using PortsOfParts = hls::Parts<PipelineOf<C>>;
  HLS_PORTS(request, frame, reply, miss, lines, waiting, use, used)

  void step() {
    const Request r = request.read();
    const auto line = set_of<C, kItems>(r.address, frame.get());
    if constexpr (kHasWays<C>) {
      look_in_ways(r, line);
    } else {
      const Row row = lines.read(line);
      // Only who misses reads it; written always, it need not wait for the comparison.
      waiting.write(Kind::key(r.context), r.context);
      if (Kind::is_known(r.address) || is_at(row, r.address)) {
        reply.write(Kind::reply(r.context, r.address, item_at<kItems>(row.line, r.address)));
      } else {
        ask_memory(r);
      }
    }
  }

 private:
  void look_in_ways(const Request& r, SetNumber<C, kItems> set) {
    WaySet<C::kWays> hits{}, empty{};
    std::array<Row, C::kWays> rows;
    for (unsigned i = 0; i < C::kWays; ++i) {
      rows[i] = lines[i].read(set);
      hits.put(i, is_at(rows[i], r.address));
      empty.put(i, !rows[i].valid || rows[i].torn);
    }
    Line line = item_at<kItems>(rows[C::kWays - 1].line, r.address);
    for (unsigned i = C::kWays - 1; i-- > 0;) {
      if (hits.has(i)) line = item_at<kItems>(rows[i].line, r.address);
    }
    const auto before = use.read(set).of_full_set(!empty.any());
    const auto way = hits.any() ? hits.first() : empty.any() ? empty.first() : before.oldest();
    waiting.write(Kind::key(r.context), {r.context, way});
    if (!Kind::is_known(r.address)) used.write(set, Use{false, before.after(way)});
    if (Kind::is_known(r.address) || hits.any()) {
      reply.write(Kind::reply(r.context, r.address, line));
    } else {
      ask_memory(r);
    }
  }
  [[gnu::nodebug]] void ask_memory(const Request& r) {
    miss.write(MemoryRequest<C>{.kind = Kind::kKind,
                                .key = Kind::key(r.context),
                                .address = r.address,
                                .pipeline = this->number()});
  }
  static bool is_at(const Row& row, Kind::Address address) {
    return hls::concat(hls::concat(row.tag, uint<1>(row.valid)), uint<1>(row.torn)) ==
           hls::concat(line_of<kItems>(address), uint<2>(0b10));
  }
};

}  // namespace dynrt
