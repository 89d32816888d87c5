// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Ways of a cache: its lines form sets of C::kWays, and an address may lie in any line of its set,
// one in each way. A miss takes the first way that holds no line; of a full set it takes the one
// that pseudo-LRU names, a tree of bits that tell which half was used longer ago. Rows of these
// bits outlive a frame, so only those of a full set count: the fills of this frame were misses,
// which wrote them.
#pragma once

#include "units/cache_sets.h"
#include "units/direct_lines.h"

namespace dynrt {

/// What waits for a line: the context of the request and the way that the line is for.
template <class C, class Context>
struct InWay {
  Context context;
  WayNumber<C> way;
  HLS_FIELDS(context, way)
};
/// Which of some ways was used longest ago, or nearly so: the lowest bit tells the half, the others
/// the way in the lower and in the upper half.
template <unsigned Ways>
struct WayTree {
  using Way = uint<hls::index_width(Ways)>;
  uint<Ways - 1> bits;
  HLS_FIELDS(bits)

  constexpr Way oldest() const {
    if constexpr (Ways == 2) {
      return bits;
    } else {
      const bool upper = bits.template bit<0>();
      const bool odd = upper ? bits.template bit<2>() : bits.template bit<1>();
      return hls::concat(uint<1>(upper), uint<1>(odd));
    }
  }
  constexpr WayTree after(Way used) const {
    if constexpr (Ways == 2) {
      return {~used};
    } else {
      const bool upper = used.template bit<1>();
      const uint<1> even = !used.template bit<0>();
      const uint<1> in_upper = upper ? even : uint<1>(bits.template bit<2>());
      const uint<1> in_lower = upper ? uint<1>(bits.template bit<1>()) : even;
      return {hls::concat(hls::concat(in_upper, in_lower), uint<1>(!upper))};
    }
  }
};

/// The use of a set.
template <class C>
struct UseRow {
  bool torn = false;  ///< hls::Hazard::kTorn
  WayTree<C::kWays> tree;
  HLS_FIELDS(torn, tree)

  /// The tree, if it counts.
  constexpr WayTree<C::kWays> of_full_set(bool full) const {
    return full && !torn ? tree : WayTree<C::kWays>{};
  }
};

/// Some of the ways.
template <unsigned Ways>
struct WaySet {
  uint<Ways> bits;
  constexpr void put(unsigned way, bool is_in) {
    bits = bits | uint<Ways>::from(is_in ? 1u << way : 0u);
  }
  constexpr bool has(unsigned way) const { return bits.bit(way); }
  constexpr bool any() const { return bits != uint<Ways>{}; }
  /// The lowest of them, or the last way if there is none.
  constexpr uint<hls::index_width(Ways)> first() const {
    using Way = uint<hls::index_width(Ways)>;
    auto way = Way::from(Ways - 1);
    for (unsigned i = Ways - 1; i-- > 0;) {
      if (has(i)) way = Way::from(i);
    }
    return way;
  }
};

template <class C, class Kind>
struct WaysToRead {
  using Line = typename Kind::Line;
  using Row = CacheRowOf<Kind>;
  using Use = UseRow<C>;
  static constexpr unsigned kItems = Kind::kItems;
  hls::RamRead<Row, kSets<C, kItems>> lines[C::kWays];
  hls::RamRead<Use, kSets<C, kItems>> use;
  hls::RamWrite<Use, kSets<C, kItems>> used;
  HLS_PORTS(lines, use, used)

  /// Whether the line of a request is there; the item that was asked for, and what waits for the
  /// line if it is not.
  template <class Request>
  bool look(const Request& r, SetNumber<C, kItems> set, Line& item,
            InWay<C, typename Kind::Context>& waits) {
    WaySet<C::kWays> hits{}, empty{};
    std::array<Row, C::kWays> rows;
    for (unsigned i = 0; i < C::kWays; ++i) {
      rows[i] = lines[i].read(set);
      hits.put(i, is_at<Kind>(rows[i], r.address));
      empty.put(i, !rows[i].valid || rows[i].torn);
    }
    item = item_at<kItems>(rows[C::kWays - 1].line, r.address);
    for (unsigned i = C::kWays - 1; i-- > 0;) {
      if (hits.has(i)) item = item_at<kItems>(rows[i].line, r.address);
    }
    const auto before = use.read(set).of_full_set(!empty.any());
    const auto way = hits.any() ? hits.first() : empty.any() ? empty.first() : before.oldest();
    waits = {r.context, way};
    if (!Kind::is_known(r.address)) used.write(set, Use{false, before.after(way)});
    return hits.any();
  }
};

template <class C, class Kind>
struct WaysToFill {
  hls::RamWrite<CacheRowOf<Kind>, kSets<C, Kind::kItems>> lines[C::kWays];
  HLS_PORTS(lines)

  /// Writes the line in its way, or invalidates the set in all, and gives the context of the
  /// request that waits for it.
  template <class Fill>
  typename Kind::Context put(const Fill& fill, SetNumber<C, Kind::kItems> set,
                             const InWay<C, typename Kind::Context>& waiting) {
    for (unsigned i = 0; i < C::kWays; ++i) {
      if (fill.invalidate || waiting.way == WayNumber<C>::from(i)) {
        lines[i].write(set,
                       {false, !fill.invalidate, line_of<Kind::kItems>(fill.address), fill.line});
      }
    }
    return waiting.context;
  }
};

}  // namespace dynrt
