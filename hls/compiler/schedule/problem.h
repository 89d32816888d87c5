// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The scheduling problem apart from its solvers: what a schedule of a unit must keep, whoever makes
// it. The rules are written twice on purpose: the solvers (schedule.h) turn them into constraints,
// and check_schedule() follows them from the circuit's operands and ports without their code.
#pragma once

#include <vector>

#include "schedule/circuit.h"
#include "schedule/delay_model.h"

namespace hlsc {

/// The stage of cells that do not matter to a path: all they give comes out of registers that are
/// far behind their blocks. Still cells are in it.
constexpr int kElsewhere = -1;

/// Clocks from the start of a transaction to the start of the next one: a pipeline takes one in
/// every clock.
constexpr int kInitiationInterval = 1;

struct Schedule {
  int stages = 1;          ///< clocks from the start of a transaction to its tokens in the FIFOs
  std::vector<int> stage;  ///< of each cell; of a still one kElsewhere: it is in all
};

struct Problem {
  const Circuit& circuit;
  const DelayModel& delay;
  double period_ns;  ///< of the clock, for every path within a stage
  double still_ns;   ///< the same for paths between still cells, which mark_still() chose by it
};

/// What a schedule must keep. Stages are clocks of one transaction; the next one's come
/// kInitiationInterval later.
///
/// 1. Stages. Every cell has one from 0 to stages - 1, or is still and has none.
/// 2. Still cells. A still cell is a Config port, or an operation on still cells alone.
/// 3. Order. An operand is in the stage of its reader or in an earlier one, unless it is still.
/// 4. Multipliers. A hard multiplier has registers on both sides: an operation or a row that it
///    reads is at least one stage before it, and a reader of its product at least one after it.
/// 5. Tokens. Tokens come in stage 0, and leave in the last stage.
/// 6. Rows. A row comes exactly its port's latency after its address (in a register file 0).
/// 7. Rows of a RAM. A RAM's row is written after the stage that reads it: in the same one its
///    value is undefined, and before it the transaction would read its own write.
/// 8. One stage. A register's next value and a register file's write are in no earlier stage than
///    the read of the same state, or later transactions would change what earlier ones read.
/// 9. Initiation interval. They are in no later stage either: what a transaction writes is there
///    when the next one reads it, kInitiationInterval clocks after its own read.
/// 10. Period. By the delay model, every path from registers to registers takes no longer than the
///    period without the model's clock_overhead.
///
/// Throws Error that names the unit, the cell with its source line, and the rule that is broken.
/// That is a mistake of a solver, never of the unit.
void check_schedule(const Problem& problem, const Schedule& schedule);

}  // namespace hlsc
