// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Direct lines: the lines of a direct-mapped cache (thesis chapter 7), where an address may lie in
// one. The two halves of a cache have the two ends of this RAM.
#pragma once

#include "units/cache_sets.h"
#include "units/memory_tokens.h"

namespace dynrt {

/// A row of a cache of this kind.
template <class Kind>
using CacheRowOf = CacheRow<Items<typename Kind::Line, Kind::kItems>,
                            Kind::Address::kWidth - kItemBits<Kind::kItems>>;
/// Whether a row holds the line of an address.
template <class Kind>
bool is_at(const CacheRowOf<Kind>& row, typename Kind::Address address) {
  return hls::concat(hls::concat(row.tag, uint<1>(row.valid)), uint<1>(row.torn)) ==
         hls::concat(line_of<Kind::kItems>(address), uint<2>(0b10));
}

template <class C, class Kind>
struct DirectLinesToRead {
  using Row = CacheRowOf<Kind>;
  hls::RamRead<Row, kSets<C, Kind::kItems>> lines;
  HLS_PORTS(lines)

  /// Whether the line of a request is there; the item that was asked for, and what waits for the
  /// line if it is not: the request's context.
  template <class Request>
  bool look(const Request& r, SetNumber<C, Kind::kItems> line, typename Kind::Line& item,
            typename Kind::Context& waits) const {
    const Row row = lines.read(line);
    item = item_at<Kind::kItems>(row.line, r.address);
    waits = r.context;
    return is_at<Kind>(row, r.address);
  }
};

template <class C, class Kind>
struct DirectLinesToFill {
  hls::RamWrite<CacheRowOf<Kind>, kSets<C, Kind::kItems>> lines;
  HLS_PORTS(lines)

  /// Writes the line and gives the context of the request that waits for it.
  template <class Fill>
  typename Kind::Context put(const Fill& fill, SetNumber<C, Kind::kItems> line,
                             const typename Kind::Context& waiting) {
    lines.write(line, {false, !fill.invalidate, line_of<Kind::kItems>(fill.address), fill.line});
    return waiting;
  }
};

}  // namespace dynrt
