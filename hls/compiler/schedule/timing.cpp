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
    : c_(circuit), d_(delay), bits_(circuit.bits), critical_(circuit.cells.size()) {}

int Timing::separation(CellId producer, CellId user) const {
  if (c_.is_multiply(producer)) return 1;
  if (!c_.is_multiply(user)) return 0;
  const CellKind kind = c_.cells[producer].kind;
  return kind == CellKind::kOperation || kind == CellKind::kRow ? 1 : 0;
}

Timing::Input Timing::input(BitRef bit, int stage, const std::vector<int>& stages) const {
  const Cell& cell = c_.cells[bit.cell];
  if (cell.kind == CellKind::kConfig || stages[bit.cell] < stage) return {0, nullptr, 0, bit};
  const Arrival& made = bits_[cell.first_bit + bit.bit];
  return {made.at, &made, 0, bit};
}

Timing::Input Timing::latest(const Cell& cell, int stage, const std::vector<int>& stages) const {
  Input last;
  for (const auto& operand : cell.operands) {
    for (const BitRef& bit : operand) {
      if (bit.is_constant()) continue;
      const Input in = input(bit, stage, stages);
      if (in.at > last.at) last = in;
    }
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
        take(c_.cells[in.bit.cell].first_bit + in.bit.bit, in.at + in.load,
             in.made ? in.bit : BitRef{});
        continue;
      }
      fits = in.made != nullptr && in.made->leaves > 0;
      if (!fits) break;
      // When the swallowed LUT's inputs came is known from its own arrival.
      for (unsigned k = 0; k < in.made->leaves && fits; ++k) {
        take(in.made->leaf[k], in.made->at - d_.lut + in.load, in.bit);
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

/// A signal that many LUTs take comes later.
double Timing::load(std::size_t loads) const {
  return loads > 8 ? d_.fanout * std::log2(static_cast<double>(loads) / 8.0) : 0.0;
}

void Timing::time_logic(const Cell& cell, int stage, const std::vector<int>& stages) {
  // Bits that an operand repeats, and the selector of a word.
  std::vector<double> repeated;
  for (const auto& operand : cell.operands) {
    const bool scalar = operand.size() == 1;
    const auto same = std::count(operand.begin(), operand.end(), operand.back());
    repeated.push_back(load(scalar ? cell.width : static_cast<std::size_t>(same)));
  }
  for (unsigned i = 0; i < cell.width; ++i) {
    std::array<Input, 3> inputs;
    unsigned count = 0;
    for (std::size_t k = 0; k < cell.operands.size(); ++k) {
      const auto& operand = cell.operands[k];
      const BitRef bit = operand[operand.size() == 1 ? 0 : i];
      if (bit.is_constant()) continue;
      inputs[count] = input(bit, stage, stages);
      if (bit == operand.back()) inputs[count].load = repeated[k];
      ++count;
    }
    bits_[cell.first_bit + i] = logic(inputs.data(), count);
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
    select = s.at + load(cell.width);
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
  while (parts.size() > 1 || parts.front().inputs > 1) {
    std::sort(parts.begin(), parts.end(), earlier);
    Part merged{0, 0, {}};
    std::size_t taken = 0;
    while (taken < parts.size() && merged.inputs + parts[taken].inputs <= d_.lut_inputs) {
      merged.inputs += parts[taken].inputs;
      if (parts[taken].at >= merged.at) {
        merged.at = parts[taken].at;
        merged.source = parts[taken].source;
      }
      ++taken;
    }
    parts.erase(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(taken));
    parts.push_back({merged.at + d_.lut, 1, merged.source});
  }
  Arrival a;
  a.at = parts.front().at;
  a.source = parts.front().source;
  return a;
}

double Timing::evaluate(CellId id, const std::vector<int>& stages) {
  const Cell& cell = c_.cells[id];
  const int stage = stages[id];
  const auto from = [](const Input& in) { return in.made != nullptr ? in.bit : BitRef{}; };
  const auto written = [&](double set_up) {
    const Input last = latest(cell, stage, stages);
    critical_[id] = from(last);
    return last.at + set_up;
  };
  switch (cell.kind) {
    case CellKind::kToken:
      set_all(cell, d_.token_in, {});
      return d_.token_in;
    case CellKind::kConfig:
    case CellKind::kRegister:
      set_all(cell, 0, {});
      return 0;
    case CellKind::kRow: {
      double at = d_.ram_out;
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
      return written(d_.token_out);
    case CellKind::kRowRead:
      return written(c_.port_of(id).kind == PortKind::kRegisterFile ? d_.lut_ram : d_.ram_in);
    case CellKind::kRowWrite:
      return written(d_.ram_in);
    case CellKind::kRegisterWrite:
      return written(0);
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
      time_logic(cell, stage, stages);
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
