// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "emit/emit.h"
#include "emit/pipeline_bits.h"
#include "netlist/op.h"

namespace hlsc {
namespace {

struct StageRow {
  std::map<std::string, unsigned> operations;
  unsigned long registers = 0;  ///< bits that enter the stage in registers
  double longest = 0;
  CellId ends_at = 0;
};

}  // namespace

std::string emit_report(const Circuit& c, const Schedule& schedule, const Options& options) {
  std::vector<StageRow> rows(static_cast<std::size_t>(schedule.stages));
  Timing timing(c, options.delay);
  for (CellId id = 0; id < c.cells.size(); ++id) {
    const double late = timing.evaluate(id, schedule.stage);
    if (schedule.stage[id] < 0) continue;
    StageRow& row = rows[static_cast<std::size_t>(schedule.stage[id])];
    if (late > row.longest) {
      row.longest = late;
      row.ends_at = id;
    }
    if (c.cells[id].kind == CellKind::kOperation) ++row.operations[op_name(c.op(id))];
  }
  unsigned long registers = 0;
  unsigned long delayed = 0;
  unsigned long delay_rows = 0;
  for (const Carry& carry : carries(c, schedule, options.delay.longest_shift)) {
    if (carry.to - carry.from > 1) {
      delayed += carry.bits;
      delay_rows += carry.bits * static_cast<unsigned long>(carry.to - carry.from);
      continue;
    }
    rows[static_cast<std::size_t>(carry.to)].registers += carry.bits;
    registers += carry.bits;
  }
  unsigned long state = 0;
  for (const Register& r : c.netlist.registers) state += r.next == kNoNode ? 0 : r.width;

  std::string text;
  const auto out = [&text]<class... A>(fmt::format_string<A...> format, A&&... args) {
    fmt::format_to(std::back_inserter(text), format, std::forward<A>(args)...);
  };
  out("unit       {}\nmodule     {}\nclock      {:.2f} ns ({})\n", c.netlist.unit, c.netlist.module,
      options.clock_ns, options.delay.name);
  if (options.uncertainty_ns > 0) out("left       {:.2f} ns to wires\n", options.uncertainty_ns);
  out("stages     {}\nregisters  {} bits between stages, {} of state\n", schedule.stages, registers,
      state);
  out("delays     {} bits wide, {} bits in all\n\n", delayed, delay_rows);
  out("stage  registers  longest path, ns  operations\n");
  for (std::size_t s = 0; s < rows.size(); ++s) {
    std::string operations;
    for (const auto& [name, count] : rows[s].operations) {
      operations += fmt::format("{}{} {}", operations.empty() ? "" : ", ", count, name);
    }
    out("{:>5}  {:>9}  {:>16.2f}  {}\n", s, rows[s].registers,
        rows[s].longest + options.delay.clock_overhead, operations);
  }
  out("\nThe longest path of each stage ends at\n");
  for (std::size_t s = 0; s < rows.size(); ++s) {
    const SourceLine where = c.where(rows[s].ends_at);
    out("{:>5}  {}{}\n", s, c.describe(rows[s].ends_at),
        where.file.empty() ? "" : fmt::format(", {}:{}", where.file, where.line));
  }
  return text;
}

}  // namespace hlsc
