// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "schedule/timing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "netlist/op.h"

namespace hlsc {

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
  if (stages[bit.cell] < stage) return {load(bit), nullptr, bit};
  const Arrival& made = bits_[cell.first_bit + bit.bit];
  return {made.at + load(bit), &made, bit};
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

/// One LUT of these inputs, swallowing the LUTs before it where that is no loss.
Timing::Arrival Timing::logic(const Input* inputs, unsigned count) const {
  Arrival best;
  bool found = false;
  for (unsigned choice = 0; choice < (1u << count); ++choice) {
    Arrival a;
    double last = 0;
    bool fits = true;
    const auto take = [&](std::uint32_t leaf, double at, BitRef source) {
      if (at > last) {
        last = at;
        a.source = source;
      }
      for (unsigned i = 0; i < a.leaves; ++i) {
        if (a.leaf[i] == leaf) return;
      }
      if (a.leaves == d_.lut_inputs || a.leaves == kMaxLeaves) {
        fits = false;
        return;
      }
      a.leaf[a.leaves++] = leaf;
    };
    for (unsigned i = 0; i < count && fits; ++i) {
      const Input& in = inputs[i];
      if ((choice >> i & 1) == 0) {
        take(c_.cells[in.bit.cell].first_bit + in.bit.bit, in.at, in.made ? in.bit : BitRef{});
        continue;
      }
      fits = in.made != nullptr && in.made->leaves > 0;
      if (!fits) break;
      // When the swallowed LUT's inputs came is known from its own arrival.
      for (unsigned k = 0; k < in.made->leaves && fits; ++k) {
        take(in.made->leaf[k], in.made->at - d_.lut, in.bit);
      }
    }
    if (!fits) continue;
    a.at = last + d_.lut;
    if (!found || a.at < best.at - 1e-9 || (a.at < best.at + 1e-9 && a.leaves < best.leaves)) {
      best = a;
      found = true;
    }
  }
  if (!found) throw std::logic_error("timing: an operation has more inputs than a LUT");
  return best;
}

void Timing::time_logic(const Cell& cell, Op op, int stage, const std::vector<int>& stages) {
  for (unsigned i = 0; i < cell.width; ++i) {
    std::array<Input, 3> inputs;
    unsigned count = 0;
    for (const auto& operand : cell.operands) {
      const BitRef bit = operand[operand.size() == 1 ? 0 : i];
      if (!bit.is_constant()) inputs[count++] = input(bit, stage, stages);
    }
    Arrival& a = bits_[cell.first_bit + i];
    const Arrival* made = inputs[0].made;
    if (op == Op::kNot && made != nullptr && made->leaves == 0) {
      a = {inputs[0].at, 0, {}, inputs[0].bit};  // what makes the bit makes its inverse as well
    } else {
      a = logic(inputs.data(), count);
    }
  }
}

/// Sum bits of a carry chain.
void Timing::time_sum(const Cell& cell, Op op, int stage, const std::vector<int>& stages) {
  const bool variable = op == Op::kAddSub;
  double carry = -1;  // no carry yet
  BitRef carry_source;
  double select = -1;
  BitRef select_bit;
  if (variable && !cell.operands[2][0].is_constant()) {
    const Input s = input(cell.operands[2][0], stage, stages);
    select = s.at;
    if (s.made != nullptr) select_bit = s.bit;
    carry = select + d_.carry_start;
    carry_source = select_bit;
  }
  for (unsigned i = 0; i < cell.width; ++i) {
    double at = -1;
    BitRef source;
    const auto join = [&](double other, BitRef bit) {
      if (other > at) {
        at = other;
        source = bit;
      }
    };
    for (unsigned k = 0; k < 2; ++k) {
      const BitRef bit = cell.operands[k][i];
      if (bit.is_constant() && !(variable && k == 1)) continue;
      Input in;
      if (!bit.is_constant()) in = input(bit, stage, stages);
      double arrival = in.at;
      BitRef from = in.made != nullptr ? in.bit : BitRef{};
      if (variable && k == 1) {
        if (select > arrival) {
          arrival = select;
          from = select_bit;
        }
        if (!d_.free_add_sub) arrival += d_.lut;
      }
      join(arrival, from);
    }
    Arrival& a = bits_[cell.first_bit + i];
    a = Arrival{};
    // A constant over a constant only passes the carry on.
    a.at = at < 0 ? 0 : at + d_.lut;
    a.source = source;
    if (carry > a.at) {
      a.at = carry;
      a.source = carry_source;
    }
    if (at >= 0 && at + d_.carry_start > carry) {
      carry = at + d_.carry_start;
      carry_source = source;
    }
    if (carry >= 0) carry += d_.carry_bit;
  }
}

Timing::Arrival Timing::compare(const Cell& cell, int stage, const std::vector<int>& stages) const {
  std::vector<Input> inputs;
  double carry = 0;
  BitRef source;
  for (std::size_t i = 0; i < cell.operands[0].size(); ++i) {
    for (const auto& operand : cell.operands) {
      if (operand[i].is_constant()) continue;
      const Input in = input(operand[i], stage, stages);
      if (inputs.size() <= d_.lut_inputs) inputs.push_back(in);
      if (in.at + d_.carry_start > carry) {
        carry = in.at + d_.carry_start;
        source = in.made != nullptr ? in.bit : BitRef{};
      }
    }
    carry += d_.carry_bit;
  }
  if (inputs.size() <= d_.lut_inputs) {
    return logic(inputs.data(), static_cast<unsigned>(inputs.size()));
  }
  Arrival a;
  a.at = carry + d_.compare_out;
  a.source = source;
  return a;
}

/// A tree of LUTs, the late bits nearest to its root.
Timing::Arrival Timing::equal(const Cell& cell, int stage, const std::vector<int>& stages) const {
  struct Part {
    double at;
    unsigned inputs;
    BitRef source;
  };
  std::vector<Input> inputs;
  std::vector<Part> parts;
  for (std::size_t i = 0; i < cell.operands[0].size(); ++i) {
    Part part{-1, 0, {}};
    for (const auto& operand : cell.operands) {
      if (operand[i].is_constant()) continue;
      const Input in = input(operand[i], stage, stages);
      inputs.push_back(in);
      ++part.inputs;
      if (in.at > part.at) {
        part.at = in.at;
        part.source = in.made != nullptr ? in.bit : BitRef{};
      }
    }
    if (part.inputs > 0) parts.push_back(part);
  }
  if (inputs.size() <= d_.lut_inputs) {
    return logic(inputs.data(), static_cast<unsigned>(inputs.size()));
  }
  const auto earlier = [](const Part& a, const Part& b) {
    return std::tie(a.at, a.inputs, a.source.cell, a.source.bit) <
           std::tie(b.at, b.inputs, b.source.cell, b.source.bit);
  };
  // LUTs of whole bits, then a tree whose first LUT takes so few that the others are full.
  std::vector<Part> tree;
  std::sort(parts.begin(), parts.end(), earlier);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool two = i + 1 < parts.size() && parts[i].inputs + parts[i + 1].inputs <= d_.lut_inputs;
    i += two ? 1 : 0;
    tree.push_back({parts[i].at + d_.lut, 1, parts[i].source});
  }
  while (tree.size() > 1) {
    const std::size_t rest = (tree.size() - 1) % (d_.lut_inputs - 1);
    const auto taken = static_cast<std::ptrdiff_t>(rest == 0 ? d_.lut_inputs : rest + 1);
    std::partial_sort(tree.begin(), tree.begin() + taken, tree.end(), earlier);
    const Part last = tree[static_cast<std::size_t>(taken) - 1];
    tree.erase(tree.begin(), tree.begin() + taken);
    tree.push_back({last.at + d_.lut, 1, last.source});
  }
  Arrival a;
  a.at = tree.front().at;
  a.source = tree.front().source;
  return a;
}

bool Timing::is_of_luts(const Port& ram) const {
  if (ram.kind == PortKind::kRegisterFile) return true;
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

/// The clock that a write allows.
double Timing::written(CellId id, const std::vector<int>& stages) {
  const Cell& cell = c_.cells[id];
  double needs = 0;
  for (std::size_t i = 0; i < cell.operands.size(); ++i) {
    const Input last = latest(cell.operands[i], stages[id], stages);
    const double late = last.at + set_up_of(id, i);
    if (late <= needs || last.bit.is_constant()) continue;
    needs = late;
    critical_[id] = last.made != nullptr ? last.bit : BitRef{};
  }
  return needs;
}

double Timing::evaluate(CellId id, const std::vector<int>& stages) {
  const Cell& cell = c_.cells[id];
  const int stage = stages[id];
  const auto from = [](const Input& in) { return in.made != nullptr ? in.bit : BitRef{}; };
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
        source = from(last);
      }
      set_all(cell, at, source);
      critical_[id] = source;
      return at;
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
      set_all(cell, last.at + d_.multiply, from(last));
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
