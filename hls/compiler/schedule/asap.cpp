// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "error.h"
#include "schedule/schedule.h"
#include "schedule/timing_messages.h"

namespace hlsc {
namespace {

/// A read and a write of state that must be in one stage.
struct Loop {
  CellId read;
  CellId write;
};

std::vector<Loop> state_loops(const Circuit& c) {
  std::vector<Loop> loops;
  for (unsigned i = 0; i < c.register_read.size(); ++i) {
    if (c.register_write[i] != BitRef::kConstant) {
      loops.push_back({c.register_read[i], c.register_write[i]});
    }
  }
  for (CellId id = 0; id < c.cells.size(); ++id) {
    if (c.cells[id].kind != CellKind::kRowWrite) continue;
    const unsigned port = c.netlist.row_writes[c.cells[id].index].port;
    if (c.netlist.ports[port].kind != PortKind::kRegisterFile) continue;
    for (unsigned r = 0; r < c.row_read.size(); ++r) {
      if (c.netlist.row_reads[r].port == port && c.row_read[r] != BitRef::kConstant) {
        loops.push_back({c.row_read[r], id});
      }
    }
  }
  return loops;
}

/// What does not fit the clock: the wording of its message, its name, its time within a stage.
struct TooSlow {
  const char* message;
  std::string name;
  double needs;
  SourceLine where;
};

class Asap {
 public:
  Asap(const Circuit& circuit, const DelayModel& delay, double clock_ns)
      : c_(circuit),
        available_(clock_ns - delay.clock_overhead),
        timing_(circuit, delay),
        before_(circuit.cells.size()),
        least_(circuit.cells.size(), 0),
        stage_(circuit.cells.size(), 0) {}

  Schedule run() {
    for (const Precedence& p : precedences(c_, timing_)) {
      if (p.of < p.user) before_[p.user].push_back(p);
    }
    const std::vector<Loop> loops = state_loops(c_);
    for (const Loop& loop : loops) check_feedback(loop);
    for (bool settled = false; !settled;) {
      place();
      settled = true;
      for (const Loop& loop : loops) {
        if (stage_[loop.write] <= stage_[loop.read]) continue;
        // Loops that share logic can drive each other on for ever.
        if (stage_[loop.write] > static_cast<int>(c_.cells.size())) throw too_slow(loop, 0);
        least_[loop.read] = stage_[loop.write];
        settled = false;
      }
    }
    for (const Loop& loop : loops) stage_[loop.write] = stage_[loop.read];
    return finish();
  }

 private:
  void place() {
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      if (c_.still[id]) {
        stage_[id] = kElsewhere;
        timing_.evaluate(id, stage_);
        continue;
      }
      int stage = least_[id];
      for (const Precedence& p : before_[id]) stage = std::max(stage, stage_[p.of] + p.distance);
      stage_[id] = stage;
      double late = timing_.evaluate(id, stage_);
      // One stage on, all comes out of registers; two on, none of these is that of a block.
      for (unsigned moved = 0; moved < 2 && late > available_ && !c_.is_source(id); ++moved) {
        ++stage_[id];
        late = timing_.evaluate(id, stage_);
      }
      if (late > available_) {
        throw TooSlow{messages::kTooSlow, c_.describe(id), late, c_.where(id)};
      }
    }
  }

  /// The time from a state's value to its next one must fit, whatever else comes out of registers.
  void check_feedback(const Loop& loop) {
    std::vector<int> stage(c_.cells.size(), kElsewhere);
    double late = 0;
    timing_.evaluate(loop.read, stage);
    stage[loop.read] = 1;
    timing_.evaluate(loop.read, stage);
    for (CellId id = loop.read + 1; id <= loop.write; ++id) {
      const Cell& cell = c_.cells[id];
      bool depends = cell.kind == CellKind::kRow && c_.row_read[cell.index] == loop.read;
      for (const auto& operand : cell.operands) {
        for (const BitRef& b : operand)
          depends = depends || (!b.is_constant() && stage[b.cell] == 1);
      }
      if (!depends || (id != loop.write && !reaches(id, loop.write))) continue;
      stage[id] = 1;
      late = timing_.evaluate(id, stage);
    }
    if (stage[loop.write] != 1 || late <= available_) return;
    throw too_slow(loop, late);
  }

  TooSlow too_slow(const Loop& loop, double late) const {
    const bool is_register = c_.cells[loop.write].kind == CellKind::kRegisterWrite;
    const std::string& name = is_register ? c_.netlist.registers[c_.cells[loop.write].index].name
                                          : c_.port_of(loop.write).name;
    return {is_register ? messages::kRegisterFeedback : messages::kFileFeedback, name, late,
            c_.where(loop.write)};
  }

  bool reaches(CellId from, CellId to) const {
    std::vector<CellId> open{from};
    std::vector<bool> seen(c_.cells.size(), false);
    while (!open.empty()) {
      const CellId id = open.back();
      open.pop_back();
      if (id == to) return true;
      for (const CellId user : c_.users[id]) {
        if (user <= to && !seen[user]) {
          seen[user] = true;
          open.push_back(user);
        }
      }
    }
    return false;
  }

  Schedule finish() {
    Schedule schedule;
    int last = 0;
    bool any = false;
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      last = std::max(last, stage_[id]);
      any = any || !c_.is_source(id);
    }
    if (!any) throw Error({c_.netlist.source, 0}, messages::kNoWrite);
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      if (c_.cells[id].kind == CellKind::kTokenWrite) stage_[id] = last;
    }
    schedule.stages = last + 1;
    schedule.stage = std::move(stage_);
    return schedule;
  }

  const Circuit& c_;
  double available_;
  Timing timing_;
  std::vector<std::vector<Precedence>> before_;
  std::vector<int> least_;
  std::vector<int> stage_;
};

constexpr double kSteps = 100;  ///< of a ns, in which periods are searched for

/// The least value that fits, to a step, between one that is missed and one that is met.
template <class T, class Fits>
T bisect(T missed, T met, T step, Fits&& fits) {
  while (met - missed > step) {
    const T middle = std::midpoint(missed, met);
    (fits(middle) ? met : missed) = middle;
  }
  return met;
}

/// The stages that a circuit takes at a period, or none if one is too short.
std::optional<int> stages_at(const Circuit& circuit, const DelayModel& delay, double clock_ns) {
  try {
    return Asap(circuit, delay, clock_ns).run().stages;
  } catch (const TooSlow&) {
    return std::nullopt;
  }
}

/// What misses this period, if anything does. The circuit's still cells may be those of another.
std::optional<TooSlow> miss(const Circuit& circuit, const DelayModel& delay, double clock_ns) {
  Circuit c(circuit.netlist);
  mark_still(c, delay, clock_ns);
  try {
    Asap(c, delay, clock_ns).run();
    return std::nullopt;
  } catch (const TooSlow& slow) {
    return slow;
  }
}

}  // namespace

void mark_still(Circuit& c, const DelayModel& delay, double clock_ns) {
  Timing timing(c, delay);
  const std::vector<int> stage(c.cells.size(), kElsewhere);
  for (CellId id = 0; id < c.cells.size(); ++id) {
    const Cell& cell = c.cells[id];
    if (c.still[id]) timing.evaluate(id, stage);
    if (cell.kind != CellKind::kOperation || c.is_multiply(id)) continue;
    bool still = true;
    for (const auto& operand : cell.operands) {
      for (const BitRef& b : operand) still = still && (b.is_constant() || c.still[b.cell]);
    }
    c.still[id] = still && timing.evaluate(id, stage) <= clock_ns - delay.clock_overhead;
  }
}

std::vector<Precedence> precedences(const Circuit& c, const Timing& timing) {
  std::vector<Precedence> all;
  for (CellId of = 0; of < c.cells.size(); ++of) {
    if (c.still[of]) continue;
    for (const CellId user : c.users[of]) all.push_back({of, user, timing.separation(of, user)});
  }
  for (CellId id = 0; id < c.cells.size(); ++id) {
    const Cell& cell = c.cells[id];
    if (cell.kind == CellKind::kRow) {
      // Exactly `latency` after the address.
      const int latency = static_cast<int>(c.port_of(id).latency);
      all.push_back({c.row_read[cell.index], id, latency});
      all.push_back({id, c.row_read[cell.index], -latency});
    }
    if (cell.kind != CellKind::kRowWrite) continue;
    const unsigned port = c.netlist.row_writes[cell.index].port;
    const Port& p = c.netlist.ports[port];
    for (unsigned r = 0; r < c.row_read.size(); ++r) {
      if (c.netlist.row_reads[r].port != port || c.row_read[r] == BitRef::kConstant) continue;
      // A transaction reads the row as it was before its own write. A RAM's row that is written in
      // the same clock is undefined.
      all.push_back({c.row_read[r], id, p.kind == PortKind::kRam ? 1 : 0});
      if (p.kind == PortKind::kRegisterFile) all.push_back({id, c.row_read[r], 0});
    }
  }
  for (unsigned i = 0; i < c.register_read.size(); ++i) {
    if (c.register_write[i] == BitRef::kConstant) continue;
    all.push_back({c.register_read[i], c.register_write[i], 0});
    all.push_back({c.register_write[i], c.register_read[i], 0});
  }
  return all;
}

double least_period(const Circuit& circuit, const DelayModel& delay, double missed_ns) {
  constexpr double kForEverNs = 1e6;
  if (const auto never = miss(circuit, delay, kForEverNs)) {
    throw Error(never->where, fmt::format(messages::kNoClock, never->name));
  }
  const auto fits_after = [&](long steps) {
    return !miss(circuit, delay, static_cast<double>(steps) / kSteps);
  };
  long missed = std::lround(std::floor(missed_ns * kSteps));
  long met = std::max(missed, 1l) * 2;
  while (!fits_after(met)) missed = std::exchange(met, 2 * met);
  return static_cast<double>(bisect(missed, met, 1l, fits_after)) / kSteps;
}

Schedule schedule_asap(const Circuit& circuit, const DelayModel& delay, double clock_ns) {
  try {
    return Asap(circuit, delay, clock_ns).run();
  } catch (const TooSlow& slow) {
    const double least = least_period(circuit, delay, clock_ns);
    // A loop that shares logic with others needs more than it needs alone.
    throw Error(slow.where,
                fmt::format(fmt::runtime(slow.message), slow.name,
                            std::max(slow.needs, least - delay.clock_overhead), clock_ns,
                            std::max(0.0, clock_ns - delay.clock_overhead), least));
  }
}

double tightest_period(const Circuit& circuit, const DelayModel& delay, double clock_ns) {
  const int stages = schedule_asap(circuit, delay, clock_ns).stages;
  return bisect(0.0, clock_ns, 1 / kSteps, [&](double period) {
    return stages_at(circuit, delay, period).value_or(stages + 1) <= stages;
  });
}

}  // namespace hlsc
