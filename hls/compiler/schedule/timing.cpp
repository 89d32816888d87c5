// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "schedule/timing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "netlist/op.h"

namespace hlsc {
namespace {

constexpr unsigned kLutRamWidth = 4;  ///< bits of a row of LUTs that are a RAM

}  // namespace

Timing::Timing(const Circuit& circuit, const DelayModel& delay)
    : c_(circuit),
      d_(delay),
      load_(circuit.bits),
      bits_(circuit.bits),
      critical_(circuit.cells.size()) {
  count_loads();
}

/// A signal that many cells take comes later. All its readers count, whatever their stages: these
/// are not known yet, and in a later stage the load is a register.
void Timing::count_loads() {
  std::vector<unsigned> loads(c_.bits);
  for (const Cell& cell : c_.cells) {
    for (const auto& operand : cell.operands) {
      const unsigned lanes = operand.size() == 1 ? std::max(cell.width, 1u) : 1;
      for (const BitRef& bit : operand) {
        if (!bit.is_constant()) loads[c_.cells[bit.cell].first_bit + bit.bit] += lanes;
      }
    }
  }
  for (unsigned i = 0; i < c_.bits; ++i) load_[i] = load(loads[i]);
}

double Timing::load(unsigned loads) const {
  return (loads > 1 ? d_.fanout_two : 0.0) + (loads > 8 ? d_.fanout * std::log2(loads / 8.0) : 0.0);
}

double Timing::load(BitRef bit) const { return load_[c_.cells[bit.cell].first_bit + bit.bit]; }

int Timing::separation(CellId producer, CellId user) const {
  if (c_.is_multiply(producer)) return 1;
  if (!c_.is_multiply(user)) return 0;
  const CellKind kind = c_.cells[producer].kind;
  return kind == CellKind::kOperation || kind == CellKind::kRow ? 1 : 0;
}

Timing::Input Timing::input(BitRef bit, int stage, const std::vector<int>& stages) const {
  const Cell& cell = c_.cells[bit.cell];
  if (stages[bit.cell] == stage - 1 && is_block(bit.cell)) {
    return {load(bit) + d_.block_register, nullptr, bit, bit};
  }
  if (stages[bit.cell] < stage) return {load(bit), nullptr, bit, {}};
  const Arrival& made = bits_[cell.first_bit + bit.bit];
  return {made.at + load(bit), &made, bit, bit};
}

Timing::Input Timing::latest(const std::vector<BitRef>& operand, int stage,
                             const std::vector<int>& stages) const {
  Input last;
  for (const BitRef& bit : operand) {
    if (bit.is_constant()) continue;
    const Input in = input(bit, stage, stages);
    if (in.at > last.at) last = in;
  }
  return last;
}

Timing::Input Timing::latest(const Cell& cell, int stage, const std::vector<int>& stages) const {
  Input last;
  for (const auto& operand : cell.operands) {
    const Input in = latest(operand, stage, stages);
    if (in.at > last.at) last = in;
  }
  return last;
}

void Timing::set_all(const Cell& cell, double at, BitRef source) {
  for (unsigned i = 0; i < cell.width; ++i) {
    Arrival& a = bits_[cell.first_bit + i];
    a = Arrival{};
    a.at = at;
    a.source = source;
  }
}

bool Timing::is_of_luts(const Port& ram) const {
  if (ram.kind == PortKind::kRegisterFile) return true;
  if (hls::asks_for_block_ram(ram.width, ram.rows)) return false;
  const unsigned width = (ram.width + kLutRamWidth - 1) / kLutRamWidth * kLutRamWidth;
  return ram.latency <= 1 && (ram.rows <= d_.lut_ram_rows || ram.rows * width <= d_.lut_ram_bits);
}

Timing::SetUp Timing::set_up(CellId write) const {
  switch (c_.cells[write].kind) {
    case CellKind::kTokenWrite:
      return {d_.token_enable, d_.token_out};
    case CellKind::kRowRead: {
      const Port& ram = c_.port_of(write);
      if (ram.kind == PortKind::kRegisterFile) return {0, d_.lut_ram};
      if (is_of_luts(ram)) return {d_.lut, d_.lut_ram};
      return {d_.lut + d_.ram_in, d_.ram_in};
    }
    case CellKind::kRowWrite: {
      const Port& ram = c_.port_of(write);
      if (!is_of_luts(ram)) return {d_.lut + d_.ram_in, d_.ram_in};
      // Every two bits of a row have a write enable of their own.
      return {2 * d_.lut + load(ram.width / 2), d_.lut};
    }
    default:
      return {};
  }
}

double Timing::set_up_of(CellId write, std::size_t operand) const {
  const SetUp needs = set_up(write);
  return operand == 0 && c_.cells[write].operands.size() > 1 ? needs.enable : needs.other;
}

double Timing::operand_needs(CellId write, std::size_t operand,
                             const std::vector<int>& stages) const {
  const Input last = latest(c_.cells[write].operands[operand], stages[write], stages);
  return last.at + set_up_of(write, operand);
}

bool Timing::is_block(CellId id) const {
  if (c_.is_multiply(id)) return true;
  return c_.cells[id].kind == CellKind::kRow && !is_of_luts(c_.port_of(id));
}

/// The clock that a write allows.
double Timing::written(CellId id, const std::vector<int>& stages) {
  const Cell& cell = c_.cells[id];
  double needs = 0;
  for (std::size_t i = 0; i < cell.operands.size(); ++i) {
    const Input last = latest(cell.operands[i], stages[id], stages);
    const double late = last.at + set_up_of(id, i);
    if (late <= needs || last.bit.is_constant()) continue;
    needs = late;
    critical_[id] = last.source;
  }
  return needs;
}

double Timing::evaluate(CellId id, const std::vector<int>& stages) {
  const Cell& cell = c_.cells[id];
  const int stage = stages[id];
  switch (cell.kind) {
    case CellKind::kToken:
      set_all(cell, d_.token_in, {});
      return d_.token_in;
    case CellKind::kConfig:
    case CellKind::kRegister:
      set_all(cell, 0, {});
      return 0;
    case CellKind::kRow: {
      double at = is_of_luts(c_.port_of(id)) ? 0 : d_.ram_out;
      BitRef source;
      if (c_.port_of(id).kind == PortKind::kRegisterFile) {
        const CellId read = c_.row_read[cell.index];
        const Input last = latest(c_.cells[read], stages[read], stages);
        at = last.at + d_.lut_ram;
        source = last.source;
      }
      set_all(cell, at, source);
      critical_[id] = source;
      return waits_in_block(id) ? 0 : at;
    }
    case CellKind::kTokenWrite:
    case CellKind::kRowRead:
    case CellKind::kRowWrite:
    case CellKind::kRegisterWrite:
      return written(id, stages);
    case CellKind::kOperation:
      break;
  }
  const Op op = c_.op(id);
  switch (op) {
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kNot:
    case Op::kMux:
      time_logic(cell, op, stage, stages);
      break;
    case Op::kAdd:
    case Op::kSub:
    case Op::kAddSub:
      time_sum(cell, op, stage, stages);
      break;
    case Op::kULt:
    case Op::kSLt:
      bits_[cell.first_bit] = compare(cell, stage, stages);
      break;
    case Op::kEq:
      bits_[cell.first_bit] = equal(cell, stage, stages);
      break;
    case Op::kMul: {
      const Input last = latest(cell, stage, stages);
      set_all(cell, last.at + d_.multiply, last.source);
      break;
    }
    default:
      throw std::logic_error(std::string("timing: ") + op_name(op) + " was not expanded");
  }
  double last = 0;
  for (unsigned i = 0; i < cell.width; ++i) {
    const Arrival& a = bits_[cell.first_bit + i];
    if (a.at >= last) {
      last = a.at;
      critical_[id] = a.source;
    }
  }
  return last;
}

}  // namespace hlsc
