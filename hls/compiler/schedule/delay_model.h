// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The delays of a device family, in ns, routing included: the data of the scheduler. The files are
// in hls/compiler/delay; each names its sources.
#pragma once

#include <string>

namespace hlsc {

struct DelayModel {
  std::string name;
  double clock_overhead = 0;  ///< from the clock to a register's output, set-up, skew
  double lut = 0;             ///< a LUT and the way to it of a signal with one load
  unsigned lut_inputs = 4;
  double fanout_two = 0;         ///< more for a signal with two loads or more
  double fanout = 0;             ///< more for each doubling of a signal's loads beyond 8
  double carry_start = 0;        ///< an adder's operand to its carry chain and from there to a sum
  double carry_bit = 0;          ///< the chain, per bit
  double compare_out = 0;        ///< a carry chain's last carry to a signal
  bool free_add_sub = false;     ///< add or subtract by a signal costs no LUT before the chain
  unsigned division_digits = 1;  ///< of a quotient in one step; 2 takes half as much logic again
  double multiply = 0;           ///< a register to a hard multiplier and through it
  double block_register = 0;     ///< how much later a register in a block's output is than others
  unsigned multiplier_width = 18;           ///< of its signed operands
  unsigned unsigned_multiplier_width = 17;  ///< of its operands where both are unsigned
  double ram_out = 0;                       ///< a synchronous RAM's data after the clock
  double ram_in = 0;                        ///< set-up of its address, data and enables
  double lut_ram = 0;                       ///< address to data of a LUT RAM
  /// Synthesis makes a RAM of LUTs if it has no more rows, or no more bits, its width rounded up to
  /// that of a RAM of LUTs. A register is then behind it, and `lut_ram` before that.
  unsigned lut_ram_rows = 0;
  unsigned lut_ram_bits = 0;
  int longest_shift = 5;    ///< a value that only waits for longer goes through a RAM
  double token_in = 0;      ///< the way of a token from another unit's FIFO
  double token_out = 0;     ///< set-up of a token's data at an Out's FIFO
  double token_enable = 0;  ///< set-up of the condition on which the FIFO takes it

  static constexpr unsigned kLeastMultiplier = 4;  ///< narrower ones are not worth their place
  bool has_multipliers() const { return multiplier_width >= kLeastMultiplier; }
};

/// Throws Error that names the file and its mistake.
DelayModel load_delay_model(const std::string& path);

}  // namespace hlsc
