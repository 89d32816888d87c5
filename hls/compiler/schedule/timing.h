// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// When each bit of a cell arrives after its stage's clock, by the delay model. Chained logic is
// packed into LUTs as a mapper would do it: a bit keeps the inputs of the LUT that makes it, and a
// user that can absorb that LUT pays for one level only. Carry chains pass bits on as they come.
#pragma once

#include <array>
#include <vector>

#include "schedule/circuit.h"
#include "schedule/delay_model.h"

namespace hlsc {

class Timing {
 public:
  Timing(const Circuit& circuit, const DelayModel& delay);

  /// Computes the arrival of a cell's bits, given the stages of its operands; operands of an
  /// earlier stage come out of registers. Returns the earliest clock edge that this cell allows:
  /// the latest bit, or the latest input and the set-up of the write.
  double evaluate(CellId id, const std::vector<int>& stage);
  /// When a bit of a cell that has been evaluated arrives after its stage's clock.
  double arrival(BitRef bit) const { return bits_[c_.cells[bit.cell].first_bit + bit.bit].at; }
  /// The clock that one operand of a write allows: its latest bit and its set-up.
  double operand_needs(CellId write, std::size_t operand, const std::vector<int>& stage) const;
  /// The bit that decided the last evaluate() of this cell: one of its stage, or of a block of the
  /// stage before; or a constant if it came from another register.
  BitRef critical_input(CellId id) const { return critical_[id]; }
  /// The same for one bit.
  BitRef critical_input(BitRef bit) const {
    return bits_[c_.cells[bit.cell].first_bit + bit.bit].source;
  }

  /// Stages that must lie between the two: hard multipliers have registers on both sides.
  int separation(CellId producer, CellId user) const;
  /// A multiplier or a RAM on the chip whose own register is behind its output. In the stage that
  /// follows, such a value comes later than one of a register among LUTs.
  bool is_block(CellId id) const;
  /// A RAM's row that waits in the RAM's own register, to which it has no way.
  bool waits_in_block(CellId id) const {
    return d_.block_register > 0 && c_.cells[id].kind == CellKind::kRow && is_block(id);
  }

 private:
  static constexpr unsigned kMaxLeaves = 6;
  /// The origin of a bit: its time, and the inputs of its LUT (none: not by one LUT).
  struct Arrival {
    double at = 0;
    unsigned leaves = 0;
    std::array<std::uint32_t, kMaxLeaves> leaf{};
    BitRef source;  ///< the input that came last, if it is of the same stage
  };
  struct Input {
    double at = 0;
    const Arrival* made = nullptr;  ///< null: out of a register
    BitRef bit;
    BitRef source;  ///< the bit, if it is of this stage or of a block of the stage before
  };

  Input input(BitRef bit, int stage, const std::vector<int>& stages) const;
  void set_all(const Cell& cell, double at, BitRef source);
  Arrival logic(const Input* inputs, unsigned count) const;
  void time_logic(const Cell& cell, Op op, int stage, const std::vector<int>& stages);
  void time_sum(const Cell& cell, Op op, int stage, const std::vector<int>& stages);
  Arrival compare(const Cell& cell, int stage, const std::vector<int>& stages) const;
  Arrival equal(const Cell& cell, int stage, const std::vector<int>& stages) const;
  Input latest(const Cell& cell, int stage, const std::vector<int>& stages) const;
  Input latest(const std::vector<BitRef>& operand, int stage, const std::vector<int>& stages) const;
  /// What the writes of a cell need beyond the arrival of their operands.
  struct SetUp {
    double enable = 0;  ///< of the condition, which a LUT joins with the valid bit of its stage
    double other = 0;   ///< of address and data
  };
  SetUp set_up(CellId write) const;
  double set_up_of(CellId write, std::size_t operand) const;
  double written(CellId id, const std::vector<int>& stages);
  void count_loads();
  double load(unsigned loads) const;
  double load(BitRef bit) const;
  /// A register file, or a RAM on the chip that synthesis makes of LUTs.
  bool is_of_luts(const Port& ram) const;

  const Circuit& c_;
  const DelayModel& d_;
  std::vector<double> load_;  ///< by the number of the bit: its way to its loads beyond that to one
  std::vector<Arrival> bits_;  ///< by the number of the bit
  std::vector<BitRef> critical_;
};

}  // namespace hlsc
