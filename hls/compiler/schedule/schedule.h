// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The solvers of the scheduling problem (problem.h), which give every cell of a circuit a pipeline
// stage: as few stages as the clock allows, and at that latency as few register bits as a linear
// program finds.
#pragma once

#include <vector>

#include "schedule/circuit.h"
#include "schedule/delay_model.h"
#include "schedule/problem.h"
#include "schedule/timing.h"

namespace hlsc {

/// Marks operations on Config ports alone as still, as far as they fit between two registers.
void mark_still(Circuit& circuit, const DelayModel& delay, double clock_ns);

/// Puts every cell into the first stage that it fits; the clock period is in ns. Throws Error if an
/// operation or a register's feedback does not fit a stage, with the least period that does.
Schedule schedule_asap(const Circuit& circuit, const DelayModel& delay, double clock_ns);

/// The least period, to a hundredth of a ns, at which the circuit takes no more stages than at this
/// one. To schedule for it costs no clock, and leaves the rest of the period to wires that are
/// longer than those of the model. It does not hold for paths between still cells: which cells are
/// still is decided before, so these paths have the period that mark_still() was given. Throws
/// Error as schedule_asap does.
double tightest_period(const Circuit& circuit, const DelayModel& delay, double clock_ns);

/// The least period for which schedule_asap finds a schedule, above one that it misses (0: any), in
/// hundredths of a ns. The circuit need not be marked for a period.
double least_period(const Circuit& circuit, const DelayModel& delay, double missed_ns);

/// Moves cells between the stages of a schedule so that fewer bits are carried from stage to stage.
Schedule minimise_registers(const Circuit& circuit, const DelayModel& delay, double clock_ns,
                            const Schedule& asap);

/// Cells that must share a stage (distance 0) or lie apart: stage[user] >= stage[of] + distance.
struct Precedence {
  CellId of;
  CellId user;
  int distance;
};
/// The constraints of the circuit itself, for any clock.
std::vector<Precedence> precedences(const Circuit& circuit, const Timing& timing);

/// Bits that live in registers between stages, without valid bits, state and delays as RAM.
unsigned long register_bits(const Circuit& circuit, const Schedule& schedule);

}  // namespace hlsc
