// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What goes over the core's memory port (units/memory_port.h), as the native twins of the adapters
// behind it have it: numbers in place of the units' tokens. Data is that of a beat.
#pragma once

#include <cstdint>

namespace dynrt {

template <class Data>
struct PortItems {
  struct Read {
    std::uint32_t id = 0;
    std::uint32_t address = 0;
    unsigned last = 0;  ///< beats less one
    friend bool operator==(const Read&, const Read&) = default;
  };
  struct Write {
    std::uint32_t address = 0;
    Data data{};
    std::uint32_t mask = 0;  ///< a bit for each half of a word
    unsigned left = 0;       ///< beats of the burst that follow
  };
  struct Beat {
    std::uint32_t id = 0;
    Data data{};
    bool last = false;
    friend bool operator==(const Beat&, const Beat&) = default;
  };
};

/// Of an answer with an error, what ends a packet's way through the scene
/// (rtl/bus/memory_filler.v): a node without children, the last entry of a list, a matrix that
/// nothing hits. Data is an array of words.
template <class Data>
Data filling_of(std::uint32_t id) {
  constexpr std::uint32_t kList = 1;  // the kind in a read's id
  Data data;
  data.fill((id & 3) == kList ? 1u << 31 : 0);
  return data;
}

/// Tokens that an hls_buffer holds.
inline constexpr unsigned kBufferedTokens = 2;

}  // namespace dynrt
