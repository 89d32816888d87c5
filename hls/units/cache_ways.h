// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Ways of a cache: its lines form sets of C::kWays, and an address may lie in any line of its set,
// one in each way. A miss takes the first way that holds no line; of a full set it takes the one
// that pseudo-LRU names, a tree of bits that tell which half was used longer ago. Rows of these
// bits outlive a frame, so only those of a full set count: the fills of this frame were misses,
// which wrote them.
#pragma once

#include <bit>
#include <type_traits>

#include "units/frame.h"
#include "units/line_items.h"

namespace dynrt {

template <class C>
inline constexpr bool kHasWays = C::kWays > 1;
/// Of lines with so many items: the more a line has, the fewer there are.
template <class C, unsigned N = 1>
inline constexpr unsigned kSets = C::kLines / C::kWays / N;
template <class C, unsigned N = 1>
using SetNumber = uint<hls::index_width(kSets<C, N>)>;
template <class C>
using WayNumber = uint<hls::index_width(C::kWays)>;

/// The set of an address, in as many sets as the frame has lines for. It has no debug info: hlsc
/// names signals by variables, which are to be those of the units.
template <class C, unsigned N = 1, unsigned W>
[[gnu::nodebug]] constexpr SetNumber<C, N> set_of(uint<W> address, const FrameRegisters<C>& frame) {
  constexpr unsigned kShift = std::bit_width(C::kWays) - 1 + kItemBits<N>;
  return SetNumber<C, N>::from(
      (line_of<N>(address).raw() & frame.line_mask.template shr<kShift>().raw()));
}

/// What waits for a line: the context of the request and, where there are ways, the way that the
/// line is for.
template <class C, class Context>
struct InWay {
  Context context;
  WayNumber<C> way;
  HLS_FIELDS(context, way)
};
template <class C, class Context>
using WaitingRow = std::conditional_t<kHasWays<C>, InWay<C, Context>, Context>;

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

}  // namespace dynrt
