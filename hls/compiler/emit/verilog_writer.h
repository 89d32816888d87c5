// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Writes one unit as a Verilog module: its head and handshake (verilog.cpp), stage by stage its
// wires and registers (stages.cpp), then the results of a transaction: registers, rows and tokens
// (state.cpp).
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "emit/emit.h"
#include "emit/expression.h"
#include "emit/names.h"
#include "emit/pipeline_bits.h"

namespace hlsc {

class VerilogWriter {
 public:
  VerilogWriter(const Circuit& circuit, const Schedule& schedule, const Options& options)
      : c_(circuit),
        n_(circuit.netlist),
        schedule_(schedule),
        options_(options),
        stems_(signal_stems(circuit)),
        expressions_(circuit),
        carries_(carries(circuit, schedule, options.delay.longest_shift)) {}

  std::string text();

 private:
  template <class... A>
  void out(fmt::format_string<A...> format, A&&... args) {
    fmt::format_to(std::back_inserter(body_), format, std::forward<A>(args)...);
  }

  int stage(CellId id) const { return schedule_.stage[id]; }
  std::string signal_name(CellId id, int stage) const {
    return fmt::format("{}_s{}", stems_[id], stage);
  }
  static std::string upper(std::string text);
  static std::string valid(int stage) { return fmt::format("valid_s{}", stage); }
  std::string bits(CellId id, std::size_t operand) {
    const int stage = c_.still[id] ? Expressions::kStillNext : this->stage(id);
    return expressions_.bits(c_.cells[id].operands[operand], stage);
  }
  /// The condition that a transaction is in the cell's stage and the cell's first operand is one.
  std::string enabled(CellId id) {
    const BitRef enable = c_.cells[id].operands[0][0];
    if (enable == BitRef{BitRef::kConstant, 1}) return valid(stage(id));
    return valid(stage(id)) + " && " + bits(id, 0);
  }
  const CellId* find(CellKind kind, unsigned port, CellId& found) const {
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      if (c_.cells[id].kind != kind || &c_.port_of(id) != &n_.ports[port]) continue;
      found = id;
      return &found;
    }
    return nullptr;
  }

  // ---- module (verilog.cpp) ----
  std::string head() const;
  /// A transaction starts when every In has a token and every Out has room for all in flight.
  void handshake();
  /// What depends on configuration alone: computed beforehand, into registers.
  void write_still();
  /// Names the signals that nothing reads, so that the linter can tell them from mistakes.
  void mark_unused();

  // ---- stages (stages.cpp) ----
  void write_stage(int s);
  std::string declare(const Carry& carry, const char* kind);
  /// One delay for all bits that go from one stage to another.
  void write_delays(const std::vector<const Carry*>& delayed);
  void write_cell(CellId id);
  /// a + b or a - b in one carry chain, whose lowest bit makes the carry.
  std::string add_sub(CellId id);
  std::string part_of(CellId id, const std::string& vector);
  std::string comment(CellId id) const;
  /// Whether an operation's operands are written in parts, or wider than they are.
  bool needs_names(CellId id) const;
  /// An unnamed operation with one use, all of it and in its own stage, needs no name.
  void find_inlined();

  // ---- what is written (state.cpp) ----
  void write_register(unsigned index);
  void write_port(unsigned index);
  void write_fifo(unsigned index);
  void write_ram(unsigned index);
  /// No transaction reads a row between another one's read and write of it.
  void assert_exclusive(const Port& p, unsigned address, int distance);
  void write_ram_end(unsigned index);

  const Circuit& c_;
  const Netlist& n_;
  const Schedule& schedule_;
  const Options& options_;
  std::vector<std::string> stems_;
  Expressions expressions_;
  std::vector<Carry> carries_;
  std::vector<bool> inlined_;
  std::set<const Port*> rows_declared_;
  std::map<std::string, std::vector<bool>> covered_;  ///< bits of inputs and rows that are read
  std::vector<std::string> unused_;
  std::string body_;
};

}  // namespace hlsc
