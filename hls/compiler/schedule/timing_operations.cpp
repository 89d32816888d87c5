// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// When the bits of one operation arrive: in LUTs, in a carry chain, in a tree of LUTs.
#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "schedule/timing.h"

namespace hlsc {

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
        take(c_.cells[in.bit.cell].first_bit + in.bit.bit, in.at, in.source);
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
    select_bit = s.source;
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
      BitRef from = in.source;
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
        source = in.source;
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
        part.source = in.source;
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

}  // namespace hlsc
