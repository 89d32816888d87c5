// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "netlist/netlist.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace hlsc {

Bits::Bits(unsigned width, std::uint64_t low) : width_(width), words_((width + 63) / 64, 0) {
  if (width == 0) return;
  words_[0] = width < 64 ? low & ((std::uint64_t{1} << width) - 1) : low;
}

void Bits::set(unsigned i, bool value) {
  const std::uint64_t mask = std::uint64_t{1} << (i % 64);
  words_[i / 64] = value ? words_[i / 64] | mask : words_[i / 64] & ~mask;
}

bool Bits::is_zero() const {
  return std::all_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word == 0; });
}

bool Bits::is_ones() const {
  for (unsigned i = 0; i < width_; ++i) {
    if (!bit(i)) return false;
  }
  return true;
}

NodeId Netlist::add(Node node) {
  nodes.push_back(std::move(node));
  return static_cast<NodeId>(nodes.size() - 1);
}

}  // namespace hlsc
