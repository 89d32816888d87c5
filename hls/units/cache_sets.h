// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The sets of a cache: with one way a set is a line.
#pragma once

#include <bit>

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

}  // namespace dynrt
