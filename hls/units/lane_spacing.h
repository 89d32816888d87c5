// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Lane spacing: the RAM of a slice's rays takes three clocks for a ray, an axis in each
// (rtl/lib/hls_ram_words.v). Where a unit sends a ray in each clock, the next one of the same lane
// may come too soon: of packets one after the other, or of a packet with few rays. Each ray is told
// how many clocks to wait, so that three pass from one to the next of its lane.
#pragma once

#include "units/packet.h"

namespace dynrt {

template <class C>
class LaneSpacing {
 public:
  /// The clocks that the next ray waits, 0 to 2, before it goes to its lane.
  uint<2> wait(RayIndex<C> lane) {
    const bool is_last = any_.template bit<0>() && lane == last_;
    const bool is_before = any_.template bit<1>() && lane == before_;
    const uint<2> clocks = is_last ? uint<2>(2) : is_before ? uint<2>(1) : uint<2>(0);
    // A ray that waits leaves an empty clock before it.
    const bool follows = !is_last && !is_before && any_.template bit<0>();
    any_ = hls::concat(uint<1>(follows), uint<1>(1));
    before_ = last_;
    last_ = lane;
    return clocks;
  }

 private:
  uint<2> any_;                ///< whether a ray went in the last clock, and in the one before
  RayIndex<C> last_, before_;  ///< their lanes
};

}  // namespace dynrt
