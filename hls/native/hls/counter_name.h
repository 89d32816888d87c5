// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The names of a top's counters: the name of a channel or a unit, and the count.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hls {

/// The tokens of a channel; the transactions of a unit, and the clocks in which one of its outputs
/// had no space.
enum class Counted : std::uint8_t { kTokens, kTransactions, kStalls };

/// The end of such a counter's name.
constexpr std::string_view suffix_of(Counted what) {
  switch (what) {
    case Counted::kTokens:
      return ".tokens";
    case Counted::kTransactions:
      return ".transactions";
    case Counted::kStalls:
      return ".stalls";
  }
  return {};
}

/// E.g. "list.stalls".
inline std::string counter_name(std::string_view of, Counted what) {
  return std::string(of).append(suffix_of(what));
}

}  // namespace hls
