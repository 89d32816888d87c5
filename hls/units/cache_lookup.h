// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Direct-mapped cache, the looking half (thesis chapter 7): 2^0 to C::kLines lines, tagged with the
// whole address so that the number of lines may change between frames. A hit is answered at once; a
// miss goes to the memory and its context is stored, so later requests do not wait. CacheFill is
// the other half and owns the writing port of the lines. A line that is replaced while it is looked
// up is a miss.
#pragma once

#include "units/frame.h"
#include "units/memory_tokens.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

/// The three caches: the content of a line, the context of a request, its key in the memory, and
/// whether the reply is known without the line.
template <class C>
struct NodeCache {
  using Context = StepContext<C>;
  using Address = NodeAddress<C>;
  using Line = CoreNode<C>;
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
struct CacheLookup {
  using Context = typename Kind::Context;
  using Line = typename Kind::Line;
  using Request = CacheRequest<Context, Kind::Address::kWidth>;
  using Row = CacheRow<Line, Kind::Address::kWidth>;
  static constexpr unsigned kRoom = kRoomForBursts<C>;

  hls::In<Request> request;
  hls::Config<FrameRegisters<C>> frame;
  hls::Out<typename Kind::Reply> reply;
  hls::Out<MemoryRequest<C>> miss;
  hls::RamRead<Row, C::kLines> lines;
  hls::RamWrite<Context, kCacheKeys<Kind>> waiting;
  hls::OptionalPort<kHasPipelines<C>, hls::Config<PipelineId<C>>> pipeline;
  HLS_PORTS(request, frame, reply, miss, lines, waiting, pipeline)

  void step() {
    const Request r = request.read();
    using Index = uint<hls::index_width(C::kLines)>;
    const Index line = Index::from((r.address.raw() & frame.get().line_mask.raw()));
    const Row row = lines.read(line);
    // Only who misses reads it; written always, it need not wait for the comparison.
    waiting.write(Kind::key(r.context), r.context);
    if (Kind::is_known(r.address) ||
        hls::concat(hls::concat(row.tag, uint<1>(row.valid)), uint<1>(row.torn)) ==
            hls::concat(r.address, uint<2>(0b10))) {
      reply.write(Kind::reply(r.context, r.address, row.line));
    } else {
      miss.write(MemoryRequest<C>{.kind = Kind::kKind,
                                  .key = Kind::key(r.context),
                                  .address = r.address,
                                  .pipeline = number()});
    }
  }

 private:
  PipelineNumber<C> number() const {
    if constexpr (kHasPipelines<C>) {
      return pipeline.get();
    } else {
      return {};
    }
  }
};

}  // namespace dynrt
