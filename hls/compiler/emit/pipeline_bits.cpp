// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "emit/pipeline_bits.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace hlsc {

std::vector<Carry> carries(const Circuit& circuit, const Schedule& schedule, int longest_shift) {
  const std::vector<int>& stage = schedule.stage;
  std::vector<int> last_use(circuit.bits, -1);
  std::vector<std::set<int>> looked_at(circuit.cells.size());
  for (CellId id = 0; id < circuit.cells.size(); ++id) {
    for (const auto& operand : circuit.cells[id].operands) {
      for (const BitRef& b : operand) {
        if (b.is_constant()) continue;
        int& last = last_use[circuit.cells[b.cell].first_bit + b.bit];
        last = std::max(last, stage[id]);
        if (stage[id] > stage[b.cell]) looked_at[b.cell].insert(stage[id]);
      }
    }
  }
  std::vector<Carry> all;
  std::map<std::pair<int, int>, unsigned> width;  // of all that goes from one stage to another
  for (CellId id = 0; id < circuit.cells.size(); ++id) {
    const Cell& cell = circuit.cells[id];
    if (circuit.still[id]) continue;
    int from = stage[id];
    for (const int to : looked_at[id]) {
      Carry carry{id, from, to, cell.width, 0, 0};
      for (unsigned i = 0; i < cell.width; ++i) {
        if (last_use[cell.first_bit + i] < to) continue;
        carry.low = std::min(carry.low, i);
        carry.high = i;
        ++carry.bits;
      }
      carry.from = from;
      carry.to = to;
      all.push_back(carry);
      width[{from, to}] += carry.bits;
      from = to;
    }
  }
  std::vector<Carry> steps;
  for (Carry carry : all) {
    const int end = carry.to;
    const bool delayed =
        end - carry.from > longest_shift && width[{carry.from, end}] >= kNarrowestDelay;
    // The delay lies anywhere: registers at both ends have the ways to it and from it in clocks of
    // their own.
    const int delay_from = carry.from + 1;
    for (; carry.from < end; carry.from = carry.to) {
      carry.to = delayed && carry.from == delay_from ? end - 1 : carry.from + 1;
      steps.push_back(carry);
    }
  }
  std::sort(steps.begin(), steps.end(), [](const Carry& a, const Carry& b) {
    return std::tie(a.to, a.cell, a.from) < std::tie(b.to, b.cell, b.from);
  });
  return steps;
}

std::vector<bool> held_still(const Circuit& circuit) {
  std::vector<bool> held(circuit.cells.size(), false);
  for (CellId id = 0; id < circuit.cells.size(); ++id) {
    if (circuit.still[id]) continue;
    for (const auto& operand : circuit.cells[id].operands) {
      for (const BitRef& b : operand) {
        if (!b.is_constant()) held[b.cell] = circuit.still[b.cell];
      }
    }
  }
  return held;
}

}  // namespace hlsc
