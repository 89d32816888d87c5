// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The number format of a board's core as the host meets it at run time: which numbers there are,
// their bits, and the words that hold them in the memory (units/memory_format.h). One is made of
// each configuration's float (memory_format_of.h), so that rounding, saturation and packing are
// those of the core; the host computes in doubles up to here.
#pragma once

#include <array>
#include <cstdint>

#include "hls/float_circuit.h"
#include "units/memory_format.h"

namespace dynrt::host {

/// A word of the scene's banks, in its lowest word_bits.
using MemoryWord = std::uint64_t;

/// The data of the memory, before they are rounded.
struct MemoryNode {
  NodeKind kind = NodeKind::kLeaf;
  double split = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
};
struct MemoryColumn {
  std::array<double, 3> value{};
  std::uint64_t spare = 0;  ///< row 0 lowest
};

struct MemoryFormat {
  unsigned exponent_bits = 0;
  unsigned mantissa_bits = 0;  ///< stored
  hls::Rounding rounding = hls::Rounding::kNearestEven;
  unsigned word_bits = 0;  ///< of a word of the scene's banks
  double smallest = 0;     ///< magnitudes
  double largest = 0;

  /// The bits of the rounded number; too large and too small ones saturate.
  std::uint32_t (*bits)(double number) = nullptr;
  double (*number)(std::uint32_t bits) = nullptr;
  /// Banks 0 and 1, and row by row.
  std::array<MemoryWord, 2> (*pack_node)(const MemoryNode& node) = nullptr;
  MemoryNode (*unpack_node)(const std::array<MemoryWord, 2>& words) = nullptr;
  std::array<MemoryWord, 3> (*pack_column)(const MemoryColumn& column) = nullptr;
  MemoryColumn (*unpack_column)(const std::array<MemoryWord, 3>& words) = nullptr;
  /// An object's box in the world, by the distances of its corners from the eye, which are rounded
  /// outwards; those beyond the bounds that a column can hold saturate.
  MemoryColumn (*box_column)(const std::array<double, 3>& low,
                             const std::array<double, 3>& high) = nullptr;

  double round(double x) const { return number(bits(x)); }
  bool holds(double x) const { return x >= -largest && x <= largest; }
  /// Words of the bus, 32 bits each, that a word of the scene's banks takes.
  unsigned bus_words() const { return (word_bits + 31) / 32; }
};

}  // namespace dynrt::host
