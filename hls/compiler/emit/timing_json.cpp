// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The ends of a unit's paths under their Verilog names, so that a placement's can be held against
// them: registers by their own name, ports of a FIFO or RAM as INSTANCE.PORT.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "emit/emit.h"
#include "emit/names.h"
#include "emit/pipeline_bits.h"
#include "hls/json_text.h"

namespace hlsc {
namespace {

struct End {
  const char* kind = "";
  double ns = 0;
  SourceLine where;
};
using Ends = std::map<std::string, End>;  ///< by the signal's name

class EndTimes {
 public:
  EndTimes(const Circuit& c, const Schedule& schedule, const Options& options, const DelayModel& d)
      : c_(c),
        schedule_(schedule),
        d_(d),
        stems_(signal_stems(c)),
        held_still_(held_still(c)),
        timing_(c, d) {
    for (CellId id = 0; id < c_.cells.size(); ++id) timing_.evaluate(id, schedule_.stage);
    for (CellId id = 0; id < c_.cells.size(); ++id) add_cell(id);
    for (const Carry& carry : carries(c, schedule, options.delay.longest_shift)) add(carry);
    add_handshake();
  }

  Ends ends() { return std::move(ends_); }

 private:
  /// Where several values go to one end, the last of them counts.
  void add(const std::string& signal, const char* kind, double ns, const SourceLine& where) {
    End& end = ends_[signal];
    if (end.kind[0] != '\0' && ns + d_.clock_overhead <= end.ns) return;
    end = {kind, ns + d_.clock_overhead, where};
  }

  /// When the last of bits [low, high] of a cell arrives.
  double latest(CellId id, unsigned low, unsigned high) const {
    double late = 0;
    for (unsigned i = low; i <= high; ++i) late = std::max(late, timing_.arrival({id, i}));
    return late;
  }

  void add(const Carry& carry) {
    const SourceLine where = c_.where(carry.cell);
    const std::string to = "_s" + std::to_string(carry.to);
    if (carry.to - carry.from > 1) {  // a delay, with a register before it
      const std::string delay = "delay_s" + std::to_string(carry.from) + to;
      add(delay + ".data_i", "delay", 0, where);
      add(delay + ".data_o", "delay", d_.lut_ram, where);
      return;
    }
    const bool made_here =
        schedule_.stage[carry.cell] == carry.from && !timing_.waits_in_block(carry.cell);
    add(stems_[carry.cell] + to, "register",
        made_here ? latest(carry.cell, carry.low, carry.high) : 0, where);
  }

  void add_cell(CellId id) {
    const Cell& cell = c_.cells[id];
    switch (cell.kind) {
      case CellKind::kRegisterWrite:
        add(stems_[c_.register_read[cell.index]] + "_q", "state",
            timing_.operand_needs(id, 0, schedule_.stage), c_.where(id));
        break;
      case CellKind::kTokenWrite:
        add_operands(id, "token", c_.port_of(id).name + "_fifo.", {"valid_i", "data_i"});
        break;
      case CellKind::kRowRead:
      case CellKind::kRowWrite:
        add_access(id, cell.kind == CellKind::kRowRead ? "read" : "write");
        break;
      default:
        if (!held_still_[id]) break;
        add(stems_[id] + "_still", "still", latest(id, 0, cell.width - 1), c_.where(id));
        break;
    }
  }

  void add_access(CellId id, const std::string& access) {
    const Port& port = c_.port_of(id);
    const char* kind = access == "read" ? "row read" : "row write";
    if (port.kind == PortKind::kRamRead || port.kind == PortKind::kRamWrite) {
      add_operands(id, kind, port.name + "_", {"en_o", "addr_o", "data_o"});
    } else {
      if (!is_read(port)) return;
      const bool is_file = port.kind == PortKind::kRegisterFile;
      const std::string enable = is_file && access == "read" ? "" : access + "_en_i";
      add_operands(id, kind, port.name + (is_file ? "_file." : "_ram."),
                   {enable, access + "_addr_i", access + "_data_i"});
    }
  }

  /// A RAM on the chip that nothing reads is left out.
  bool is_read(const Port& ram) const {
    const auto& reads = c_.row_read;
    return std::any_of(reads.begin(), reads.end(), [&](CellId read) {
      return read != BitRef::kConstant && &c_.port_of(read) == &ram;
    });
  }

  /// Operands without a port go nowhere: every clock reads a register file. A condition that is
  /// always true leaves the valid bit of its stage, a register.
  void add_operands(CellId id, const char* kind, const std::string& stem,
                    const std::vector<std::string>& ports) {
    const auto& operands = c_.cells[id].operands;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const bool constant = std::all_of(operands[i].begin(), operands[i].end(),
                                        [](const BitRef& b) { return b.is_constant(); });
      if ((constant && i > 0) || ports[i].empty()) continue;
      add(stem + ports[i], kind, timing_.operand_needs(id, i, schedule_.stage), c_.where(id));
    }
  }

  /// A transaction starts when every In has a token and every Out has room; its valid bit then goes
  /// from stage to stage, and each In's FIFO lets its token go.
  void add_handshake() {
    unsigned in = 0;
    unsigned out = 0;
    for (const Port& p : c_.netlist.ports) in += p.kind == PortKind::kIn ? 1 : 0;
    for (const Cell& cell : c_.cells) out += cell.kind == CellKind::kTokenWrite ? 1 : 0;
    const SourceLine unit{c_.netlist.source, 0};
    if (schedule_.stages > 1) {
      add("valid_s1", "valid", (in > 0 ? d_.token_in : 0) + d_.lut * levels(in + out), unit);
    }
    for (int s = 2; s < schedule_.stages; ++s) add("valid_s" + std::to_string(s), "valid", 0, unit);
    for (const Port& p : c_.netlist.ports) {
      if (p.kind != PortKind::kIn) continue;
      add(p.name + "_ready_o", "ready",
          (in > 1 ? d_.token_in : 0) + d_.lut * levels(in - 1 + out) + d_.token_enable, p.where);
    }
  }

  /// Of LUTs that make one condition of several.
  unsigned levels(unsigned conditions) const {
    unsigned count = 0;
    for (; conditions > 1; ++count) {
      conditions = (conditions + d_.lut_inputs - 1) / d_.lut_inputs;
    }
    return count;
  }

  const Circuit& c_;
  const Schedule& schedule_;
  const DelayModel& d_;
  std::vector<std::string> stems_;
  std::vector<bool> held_still_;
  Timing timing_;
  Ends ends_;
};

}  // namespace

std::string emit_timing(const Circuit& c, const Schedule& schedule, const Options& options) {
  using Json = nlohmann::ordered_json;
  std::vector<const DelayModel*> models{&options.delay};
  for (const DelayModel& d : options.time_by) models.push_back(&d);
  Json names = Json::array();
  std::vector<Ends> times;
  for (const DelayModel* model : models) {
    names.push_back(model->name);
    times.push_back(EndTimes(c, schedule, options, *model).ends());
  }
  std::string ends;  // one a line
  for (const auto& [signal, end] : times.front()) {
    Json ns = Json::array();
    for (const Ends& by : times) ns.push_back(std::round(by.at(signal).ns * 1e9) / 1e9);
    const std::string source = end.where.line == 0
                                   ? end.where.file
                                   : end.where.file + ":" + std::to_string(end.where.line);
    const Json line = {{"signal", signal}, {"kind", end.kind}, {"source", source}, {"ns", ns}};
    ends += (ends.empty() ? "\n    " : ",\n    ") + hls::with_whole_numbers(line).dump();
  }
  return fmt::format(
      "{{\n  \"unit\": {},\n  \"module\": {},\n  \"clock_ns\": {},\n  \"models\": {},\n"
      "  \"ends\": [{}\n  ]\n}}\n",
      Json(c.netlist.unit).dump(), Json(c.netlist.module).dump(),
      hls::with_whole_numbers(Json(options.clock_ns)).dump(), names.dump(), ends);
}

}  // namespace hlsc
