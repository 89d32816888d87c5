// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "emit/verilog_writer.h"
#include "netlist/op.h"

namespace hlsc {
namespace {

constexpr std::size_t kLongestInline = 60;  ///< characters of an unnamed expression within another

}  // namespace

void VerilogWriter::write_stage(int s) {
  out("\n  // ---- stage {} ----\n", s);
  std::string clocked;
  const auto next = [&clocked]<class... A>(fmt::format_string<A...> format, A&&... args) {
    fmt::format_to(std::back_inserter(clocked), format, std::forward<A>(args)...);
  };
  if (s > 0) {
    out("  reg valid_s{};\n", s);
    next("    valid_s{} <= rst_ni && valid_s{};\n", s, s - 1);
  }
  std::vector<const Carry*> delayed;
  for (const Carry& carry : carries_) {
    if (carry.to != s) continue;
    const bool is_register = carry.to - carry.from == 1;
    const std::string name = declare(carry, is_register ? "reg " : "wire");
    if (is_register) {
      next("    {} <= {};\n", name,
           expressions_.range(carry.cell, carry.from, carry.low, carry.high));
    } else {
      delayed.push_back(&carry);
    }
  }
  if (!clocked.empty()) out("  always @(posedge clk_i) begin\n{}  end\n", clocked);
  write_delays(delayed);
  for (CellId id = 0; id < c_.cells.size(); ++id) {
    if (stage(id) == s && c_.cells[id].width > 0) write_cell(id);
  }
}

std::string VerilogWriter::declare(const Carry& carry, const char* kind) {
  const Cell& cell = c_.cells[carry.cell];
  Signal signal{signal_name(carry.cell, carry.to), carry.low, carry.high, 0, cell.width == 1};
  const std::string name = signal.name;
  out("  {} {}{};\n", kind, cell.width == 1 ? "" : fmt::format("[{}:{}] ", carry.high, carry.low),
      name);
  expressions_.declare(carry.cell, carry.to, std::move(signal));
  return name;
}

void VerilogWriter::write_delays(const std::vector<const Carry*>& delayed) {
  for (std::size_t i = 0; i < delayed.size(); ++i) {
    const int from = delayed[i]->from;
    bool first = true;
    for (std::size_t k = 0; k < i; ++k) first = first && delayed[k]->from != from;
    if (!first) continue;
    std::string in;
    std::string to;
    unsigned width = 0;
    for (const Carry* carry : delayed) {
      if (carry->from != from) continue;
      const char* comma = in.empty() ? "" : ", ";
      in += comma + expressions_.range(carry->cell, from, carry->low, carry->high);
      to += comma + signal_name(carry->cell, carry->to);
      width += carry->high - carry->low + 1;
    }
    out("  hls_delay #(.WIDTH({}), .CLOCKS({})) delay_s{}_s{} (\n"
        "    .clk_i(clk_i), .rst_ni(rst_ni),\n    .data_i({{{}}}),\n    .data_o({{{}}}));\n",
        width, delayed[i]->to - from, from, delayed[i]->to, in, to);
  }
}

void VerilogWriter::write_cell(CellId id) {
  const Cell& cell = c_.cells[id];
  const int s = stage(id);
  const std::string range = bit_range(cell.width);
  if (cell.kind == CellKind::kOperation && inlined_[id]) {
    std::string text = expressions_.operation(id, s);
    if (text.size() <= kLongestInline) {
      expressions_.inline_as(id, std::move(text));
      return;
    }
  }
  const std::string name =
      cell.kind == CellKind::kRegister ? stems_[id] + "_q" : signal_name(id, s);
  std::string value;
  switch (cell.kind) {
    case CellKind::kToken:
      value = part_of(id, c_.port_of(id).name + "_data_i");
      break;
    case CellKind::kRow: {
      const Port& p = c_.port_of(id);
      const bool external = p.kind == PortKind::kRamRead;
      if (!external && rows_declared_.insert(&p).second) {
        out("  wire {}{}_row;\n", bit_range(p.width), p.name);
      }
      value = part_of(id, p.name + (external ? "_data_i" : "_row"));
      break;
    }
    case CellKind::kRegister:
      out("  reg  {}{};\n", range, name);
      break;
    default:
      if (c_.op(id) == Op::kAddSub) {
        value = add_sub(id);
      } else {
        value = expressions_.operation(id, s);
      }
      break;
  }
  if (!value.empty()) out("  wire {}{} = {};{}\n", range, name, value, comment(id));
  expressions_.declare(id, s, {name, 0, cell.width - 1, 0, cell.width == 1});
}

std::string VerilogWriter::add_sub(CellId id) {
  const Cell& cell = c_.cells[id];
  const std::string sum = stems_[id] + "_sum";
  out("  wire [{0}:0] {1} = {{{2}, 1'b1}} + {{{3} ^ {{{0}{{{4}}}}}, {4}}};\n", cell.width, sum,
      bits(id, 0), bits(id, 1), bits(id, 2));
  unused_.push_back(sum + "[0]");
  return fmt::format("{}[{}:1]", sum, cell.width);
}

std::string VerilogWriter::part_of(CellId id, const std::string& vector) {
  const Cell& cell = c_.cells[id];
  const Port& p = c_.port_of(id);
  covered_[vector].resize(p.width);
  for (unsigned i = 0; i < cell.width; ++i) covered_[vector][cell.low + i] = true;
  if (cell.width == p.width) return vector;
  if (cell.width == 1) return fmt::format("{}[{}]", vector, cell.low);
  return fmt::format("{}[{}:{}]", vector, cell.low + cell.width - 1, cell.low);
}

std::string VerilogWriter::comment(CellId id) const {
  const SourceLine where = c_.where(id);
  if (c_.cells[id].kind != CellKind::kOperation || where.file.empty()) return "";
  return fmt::format("  // {}:{}", where.file, where.line);
}

bool VerilogWriter::needs_names(CellId id) const {
  if (c_.cells[id].kind != CellKind::kOperation) return false;
  const Op op = c_.op(id);
  if (op == Op::kMul || op == Op::kAddSub) return true;
  if (op != Op::kMux) return false;
  unsigned constants = 0;
  const auto& sides = c_.cells[id].operands;
  for (unsigned i = 0; i < c_.cells[id].width; ++i) {
    constants += sides[1][i].is_constant() || sides[2][i].is_constant() ? 1 : 0;
  }
  return constants > 0 && c_.cells[id].width > 1;
}

void VerilogWriter::find_inlined() {
  std::vector<unsigned> uses(c_.cells.size(), 0);
  std::vector<bool> whole(c_.cells.size(), true);
  for (CellId id = 0; id < c_.cells.size(); ++id) {
    for (const auto& operand : c_.cells[id].operands) {
      std::set<CellId> read;
      for (const BitRef& b : operand) {
        if (!b.is_constant()) read.insert(b.cell);
      }
      for (const CellId of : read) {
        ++uses[of];
        bool all = operand.size() == c_.cells[of].width && stage(of) == stage(id);
        for (std::size_t i = 0; i < operand.size(); ++i) {
          all = all && operand[i] == BitRef{of, static_cast<std::uint32_t>(i)};
        }
        if (needs_names(id)) all = false;
        whole[of] = whole[of] && all;
      }
    }
  }
  inlined_.assign(c_.cells.size(), false);
  for (CellId id = 0; id < c_.cells.size(); ++id) {
    if (c_.cells[id].kind != CellKind::kOperation || uses[id] != 1 || !whole[id]) continue;
    const Node& node = n_.nodes[c_.cells[id].node];
    const bool large = node.op == Op::kMul || node.op == Op::kAddSub || node.op == Op::kSLt;
    inlined_[id] = node.name.empty() && !large;
  }
}

}  // namespace hlsc
