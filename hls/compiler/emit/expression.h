// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Verilog expressions: the bits of a cell in a stage, and the text of each operation.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "schedule/schedule.h"

namespace hlsc {

std::string bit_range(unsigned width);  ///< "[7:0] ", or "" for one bit
std::string literal(const Bits& value);

/// A declared vector or scalar that holds bits of a cell.
struct Signal {
  std::string name;
  unsigned declared_low = 0;  ///< lowest index that the name has
  unsigned declared_high = 0;
  unsigned offset = 0;       ///< index of the cell's bit 0
  bool scalar = false;       ///< declared without a range
  std::vector<bool> used{};  ///< indices from declared_low
};

/// Writes expressions and remembers which bits of which signals they use.
class Expressions {
 public:
  explicit Expressions(const Circuit& circuit);

  /// Of a still cell: its register, and what the register takes.
  static constexpr int kStill = -1;
  static constexpr int kStillNext = -2;
  void declare(CellId cell, int stage, Signal signal);
  /// The cell is written into its only user's expression.
  void inline_as(CellId cell, std::string text) { inlined_[cell] = std::move(text); }

  /// The bits as they are in a stage, lowest first.
  std::string bits(const std::vector<BitRef>& operand, int stage);
  std::string range(CellId cell, int stage, unsigned low, unsigned high);
  /// The expression of an operation.
  std::string operation(CellId cell, int stage);

  /// "name[3:1]", for every range that nothing uses, in the order of declaration.
  std::vector<std::string> unused() const;

 private:
  Signal& signal(CellId cell, int stage);
  std::string mux(const Cell& cell, int stage);
  std::string multiply(const Cell& cell, int stage);

  const Circuit& c_;
  std::map<std::pair<CellId, int>, std::size_t> index_;
  std::vector<Signal> signals_;
  std::map<CellId, std::string> inlined_;
};

}  // namespace hlsc
