// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs a netlist, transaction by transaction; its Verilog must agree to the last bit.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "netlist/netlist.h"

namespace hlsc {

/// A row that a transaction has written.
struct WrittenRow {
  unsigned port;
  std::uint64_t address;
  Bits row;
};

class Interpreter {
 public:
  /// The netlist must outlive the interpreter.
  explicit Interpreter(const Netlist& netlist);

  /// Of a Config port.
  void set_config(unsigned port, const Bits& value) { config_[port] = value; }
  /// Contents of a RAM, register file or RAM end, by row; all zero at first.
  std::vector<Bits>& rows(unsigned port) { return rows_.at(port); }

  /// One transaction. `tokens` and the result are indexed by port; an Out that is not written has
  /// no value.
  std::vector<std::optional<Bits>> step(const std::vector<Bits>& tokens);
  /// The writes of the last transaction to RAMs of all kinds.
  const std::vector<WrittenRow>& written_rows() const { return written_rows_; }

 private:
  Bits value_of(NodeId id, const std::vector<Bits>& tokens) const;

  const Netlist& netlist_;
  std::map<unsigned, Bits> config_;
  std::map<unsigned, std::vector<Bits>> rows_;
  std::vector<Bits> registers_;
  std::vector<Bits> values_;
  std::vector<WrittenRow> written_rows_;
};

}  // namespace hlsc
