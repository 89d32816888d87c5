// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Tokens of the caches and of the memory behind them (thesis 7). C is a configuration
// (hls/configs).
#pragma once

#include <algorithm>

#include "units/frame.h"
#include "units/line_items.h"
#include "units/packet.h"
#include "units/pipelines.h"
#include "units/transformation_tokens.h"
#include "units/traversal_tokens.h"

namespace dynrt {

/// `AddressBits` are those of the core's nodes or columns.
template <class Context, unsigned AddressBits = kAddressBits>
struct CacheRequest {
  Context context;
  uint<AddressBits> address;
  HLS_FIELDS(context, address)
};

/// `line` is the item that was asked for: a node, a list entry or a matrix column.
template <class Context, class Line, unsigned AddressBits = kAddressBits>
struct CacheReply {
  Context context;
  uint<AddressBits> address;
  Line line;
  HLS_FIELDS(context, address, line)
};

/// A line, with the bits of its address that all of its items have.
template <class Line, unsigned AddressBits = kAddressBits>
struct CacheRow {
  bool torn = false;  ///< hls::Hazard::kTorn
  bool valid = false;
  uint<AddressBits> tag;
  Line line;
  HLS_FIELDS(torn, valid, tag, line)
};

enum class MemoryKind : unsigned char { kNode, kList, kColumn };

/// Whether the scene's memory takes several clocks for a read, as a slower one would
/// (thesis 7.2.5).
template <class C>
inline constexpr bool kSlowMemory = C::kMemoryClocks > 1;

/// Whether the caches of all pipelines have a second level behind them (units/memory_port.h).
template <class C>
inline constexpr bool kHasSecondLevel = C::kSecondLevel > 0;

/// `key` names the request within its cache: the packet, or packet and column.
template <class C>
struct MemoryRequest {
  static constexpr unsigned kAddressBits =
      std::max(NodeAddress<C>::kWidth, ColumnAddress<C>::kWidth);

  /// Clocks of the read less one; of an order to invalidate the second level, sets less one.
  [[no_unique_address]] UsualField<kSlowMemory<C> || kHasSecondLevel<C>,
                                   uint<kHasSecondLevel<C> ? 14 : 4>> repeat{C::kMemoryClocks - 1};
  MemoryKind kind = MemoryKind::kNode;
  uint<2 + PacketId<C>::kWidth> key;
  uint<kAddressBits> address;
  [[no_unique_address]] PipelineNumber<C> pipeline{};
  [[no_unique_address]] UsualField<kHasSecondLevel<C>, bool> invalidate{};  ///< no read
  [[no_unique_address]] UsualField<kHasSecondLevel<C>, uint<8>> tries{};    ///< while its line came
  HLS_FIELDS(repeat, kind, key, address, pipeline, invalidate, tries)
};

/// A line for a cache: the answer to a request for the item at `address`, or the order to
/// invalidate the line that it would lie in.
template <class C, class Line, unsigned AddressBits = kAddressBits>
struct CacheLine {
  bool invalidate = false;
  uint<2 + PacketId<C>::kWidth> key;
  uint<AddressBits> address;
  Line line;
  HLS_FIELDS(invalidate, key, address, line)
};
template <class C>
using NodeLine = CacheLine<C, Items<CoreNode<C>, kNodesOfLine<C>>, NodeAddress<C>::kWidth>;
template <class C>
using ListLine = CacheLine<C, Items<CoreListEntry<C>, kEntriesOfLine<C>>, NodeAddress<C>::kWidth>;
template <class C>
using ColumnLine = CacheLine<C, MatrixColumn<typename C::Real>, ColumnAddress<C>::kWidth>;

/// The column of the box of an object whose matrix had the number 0, as it lies from where the rays
/// of a job start.
template <class C>
ColumnAddress<C> first_box(const FrameRegisters<C>& frame, const TransformExtras<C>& job) {
  auto column = frame.box_column.get().template trunc<ColumnAddress<C>::kWidth>();
  if constexpr (kTestsBoxOfLight<C>) {
    auto apart = frame.boxes_apart.get().template trunc<ColumnAddress<C>::kWidth>();
    for (unsigned i = 0; i < Viewpoint<C>::kWidth; ++i) {
      if (job.viewpoint.get().bit(i)) column = ColumnAddress<C>::from((column + apart).raw());
      apart = apart.template shl<1>();
    }
  }
  return column;
}

template <class C>
using NodeRequest = CacheRequest<StepContext<C>, NodeAddress<C>::kWidth>;
template <class C>
using ListRequest = CacheRequest<ListContext<C>, NodeAddress<C>::kWidth>;
template <class C>
using ColumnRequest = CacheRequest<ColumnContext<C>, ColumnAddress<C>::kWidth>;
template <class C>
using ColumnReply =
    CacheReply<ColumnContext<C>, MatrixColumn<typename C::Real>, ColumnAddress<C>::kWidth>;

}  // namespace dynrt

template <>
inline constexpr unsigned hls::enum_width<dynrt::MemoryKind> = 2;
