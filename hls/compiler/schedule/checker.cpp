// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Follows the rules of problem.h one after the other. Timing stands for the delay model; all else
// comes from the circuit's cells, their operands and ports.
#include <fmt/format.h>

#include <string>

#include "error.h"
#include "schedule/problem.h"
#include "schedule/timing.h"

namespace hlsc {
namespace {

constexpr char kWrong[] =
    "hlsc made a wrong schedule of {}: {}; this is a mistake in hlsc and not in the unit, please "
    "report it";
constexpr double kRoundingNs = 1e-9;

class Checker {
 public:
  Checker(const Problem& problem, const Schedule& schedule)
      : c_(problem.circuit), problem_(problem), stages_(schedule.stages), stage_(schedule.stage) {}

  void run() const {
    if (stage_.size() != c_.cells.size()) {
      fail({c_.netlist.source, 0},
           fmt::format("{} of {} cells have a stage", stage_.size(), c_.cells.size()));
    }
    for (CellId id = 0; id < c_.cells.size(); ++id) check_stage(id);
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      for (const auto& operand : c_.cells[id].operands) {
        for (const BitRef& bit : operand) {
          if (!bit.is_constant()) check_operand(id, bit.cell);
        }
      }
      check_port(id);
    }
    for (CellId id = 0; id < c_.cells.size(); ++id) check_write(id);
    check_period();
  }

 private:
  [[noreturn]] void fail(const SourceLine& where, const std::string& broken) const {
    throw Error(where, fmt::format(kWrong, c_.netlist.unit, broken));
  }
  [[noreturn]] void fail(CellId id, const std::string& broken) const {
    fail(c_.where(id), place(id) + ", but " + broken);
  }

  /// "'sum' (add of 8 bits) is in stage 2".
  std::string place(CellId id) const {
    if (c_.still[id]) return c_.describe(id) + " stands still";
    return fmt::format("{} is in stage {}", c_.describe(id), stage_[id]);
  }

  void check_stage(CellId id) const {
    const CellKind kind = c_.cells[id].kind;
    if (!c_.still[id]) {
      if (stage_[id] < 0 || stage_[id] >= stages_) {
        fail(id, fmt::format("the stages are 0 to {}", stages_ - 1));
      }
      return;
    }
    if (stage_[id] != kElsewhere) fail(id, fmt::format("it has stage {}", stage_[id]));
    if (kind != CellKind::kConfig && kind != CellKind::kOperation) {
      fail(id, "only configuration does");
    }
  }

  bool is_multiplier(CellId id) const {
    const Cell& cell = c_.cells[id];
    return cell.kind == CellKind::kOperation && c_.netlist.nodes[cell.node].op == Op::kMul;
  }

  void check_operand(CellId id, CellId of) const {
    if (c_.still[of]) return;
    if (c_.still[id]) fail(id, "reads a value that does not: " + place(of));
    if (stage_[of] > stage_[id]) fail(id, "reads a value that comes later: " + place(of));
    const CellKind kind = c_.cells[of].kind;
    const bool is_made = kind == CellKind::kOperation || kind == CellKind::kRow;
    if (!is_multiplier(of) && !(is_multiplier(id) && is_made)) return;
    if (stage_[of] == stage_[id]) {
      fail(id, place(of) + " too, and a multiplier has registers on both sides");
    }
  }

  void check_port(CellId id) const {
    const Cell& cell = c_.cells[id];
    if (cell.kind == CellKind::kToken && stage_[id] != 0) fail(id, "tokens come in stage 0");
    if (cell.kind == CellKind::kTokenWrite && stage_[id] != stages_ - 1) {
      fail(id, fmt::format("tokens leave in the last stage, {}", stages_ - 1));
    }
    if (cell.kind != CellKind::kRow) return;
    const CellId read = c_.row_read[cell.index];
    const unsigned latency = c_.port_of(id).latency;
    if (stage_[id] != stage_[read] + static_cast<int>(latency)) {
      fail(id, fmt::format("{}, and a row comes {} stages after its read", place(read), latency));
    }
  }

  void check_write(CellId write) const {
    const Cell& cell = c_.cells[write];
    for (CellId read = 0; read < c_.cells.size(); ++read) {
      const Cell& other = c_.cells[read];
      if (cell.kind == CellKind::kRegisterWrite) {
        if (other.kind == CellKind::kRegister && other.index == cell.index) share(read, write);
      } else if (cell.kind == CellKind::kRowWrite) {
        if (other.kind != CellKind::kRowRead || &c_.port_of(read) != &c_.port_of(write)) continue;
        if (c_.port_of(write).kind == PortKind::kRegisterFile) {
          share(read, write);
        } else if (stage_[write] <= stage_[read]) {
          fail(write,
               place(read) + ", and a RAM's row is written in a later stage than it is read");
        }
      }
    }
  }

  /// A state's read and write.
  void share(CellId read, CellId write) const {
    const int later = stage_[write] - stage_[read];
    if (later < 0) {
      fail(write, place(read) + ", so that it reads what later transactions write");
    }
    if (later >= kInitiationInterval) {
      fail(write, fmt::format("{}, so that a transaction could start only every {} clocks",
                              place(read), later + 1));
    }
  }

  void check_period() const {
    Timing timing(c_, problem_.delay);
    for (CellId id = 0; id < c_.cells.size(); ++id) {
      const double period = c_.still[id] ? problem_.still_ns : problem_.period_ns;
      const double needs = timing.evaluate(id, stage_) + problem_.delay.clock_overhead;
      if (needs > period + kRoundingNs) {
        fail(id,
             fmt::format("the path to it needs {:.2f} ns of a period of {:.2f}", needs, period));
      }
    }
  }

  const Circuit& c_;
  const Problem& problem_;
  const int stages_;
  const std::vector<int>& stage_;
};

}  // namespace

void check_schedule(const Problem& problem, const Schedule& schedule) {
  Checker(problem, schedule).run();
}

}  // namespace hlsc
