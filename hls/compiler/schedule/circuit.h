// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The circuit that the scheduler places: the netlist without its wiring (slices, concatenations,
// sign extensions, constants), so that every operand is a list of bits of the cells that compute
// them. A field of a token is a cell of its own. Cells are in topological order.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "netlist/netlist.h"

namespace hlsc {

using CellId = std::uint32_t;

/// A bit of a cell's value, or a constant.
struct BitRef {
  static constexpr CellId kConstant = ~CellId{0};
  CellId cell = kConstant;
  std::uint32_t bit = 0;  ///< of a constant: its value
  bool is_constant() const { return cell == kConstant; }
  bool operator==(const BitRef&) const = default;
};

enum class CellKind : std::uint8_t {
  kToken,          ///< bits of In port `index`; in stage 0
  kConfig,         ///< bits of Config port `index`; still
  kRegister,       ///< register `index` before the transaction
  kRow,            ///< bits of the row of row read `index`
  kOperation,      ///< netlist node `node`
  kTokenWrite,     ///< token write `index`: enable, data; in the last stage
  kRowRead,        ///< row read `index`: enable, address
  kRowWrite,       ///< row write `index`: enable, address, data
  kRegisterWrite,  ///< register `index`: next value
};

struct Cell {
  CellKind kind = CellKind::kOperation;
  unsigned index = 0;
  NodeId node = kNoNode;   ///< the operation; of a source the first node that reads it
  unsigned low = 0;        ///< of a source: its lowest bit in token, row or value
  unsigned width = 0;      ///< of the value; 0 where there is none
  unsigned first_bit = 0;  ///< number of bit 0 when the bits of all cells are counted through
  std::vector<std::vector<BitRef>> operands;
};

struct Circuit {
  explicit Circuit(const Netlist& netlist);

  const Netlist& netlist;
  std::vector<Cell> cells;
  unsigned bits = 0;  ///< of all cells
  /// Of each cell, ascending, each once; the row of a register file is a user of its read.
  std::vector<std::vector<CellId>> users;
  std::vector<CellId> row_read;        ///< cell of each row read, or BitRef::kConstant
  std::vector<CellId> register_read;   ///< cell of each register, or BitRef::kConstant
  std::vector<CellId> register_write;  ///< the same
  /// Cells that stand still while transactions run, so that one register has each of them for all
  /// stages: Config ports, and what mark_still() adds.
  std::vector<bool> still;

  Op op(CellId id) const { return netlist.nodes[cells[id].node].op; }
  bool is_multiply(CellId id) const {
    return cells[id].kind == CellKind::kOperation && op(id) == Op::kMul;
  }
  bool is_source(CellId id) const { return cells[id].kind <= CellKind::kRow; }
  const Port& port_of(CellId id) const;
  SourceLine where(CellId id) const;
  /// "'distance' (sub)", "the write to fresh": for messages.
  std::string describe(CellId id) const;
};

}  // namespace hlsc
