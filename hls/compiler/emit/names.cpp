// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "emit/names.h"

#include <cctype>
#include <map>

#include "netlist/op.h"

namespace hlsc {
namespace {

std::string identifier(const std::string& name) {
  std::string id;
  for (const char c : name) {
    const bool fits = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (fits) {
      id += c;
    } else if (!id.empty() && id.back() != '_') {
      id += '_';
    }
  }
  while (!id.empty() && id.back() == '_') id.pop_back();
  if (id.empty() || std::isdigit(static_cast<unsigned char>(id.front())) != 0) id = "v" + id;
  return id;
}

std::string wanted(const Circuit& c, CellId id) {
  const Cell& cell = c.cells[id];
  const Node& node = c.netlist.nodes[cell.node];
  switch (cell.kind) {
    case CellKind::kRegister:
      return identifier(c.netlist.registers[cell.index].name);
    case CellKind::kOperation:
      return node.name.empty() ? "" : identifier(node.name);
    default: {
      const bool whole = node.low == cell.low && node.width == cell.width;
      if (whole && !node.name.empty()) return identifier(node.name);
      const std::string port = identifier(c.port_of(id).name);
      if (cell.width == c.port_of(id).width) return port;
      return port + "_" + std::to_string(cell.low);
    }
  }
}

}  // namespace

std::vector<std::string> signal_stems(const Circuit& circuit) {
  std::vector<std::string> stems(circuit.cells.size());
  // Taken by the module itself.
  std::set<std::string> taken{"valid", "delay", "fire", "unused"};
  std::map<std::string, unsigned> count;
  const auto take = [&](CellId id, const std::string& stem, bool numbered) {
    std::string name = stem;
    if (numbered) name += "_" + std::to_string(++count[stem]);
    while (!taken.insert(name).second) name = stem + "_" + std::to_string(++count[stem]);
    stems[id] = name;
  };
  // Named ones first, so that they keep their names.
  for (const bool named : {true, false}) {
    for (CellId id = 0; id < circuit.cells.size(); ++id) {
      if (circuit.cells[id].width == 0) continue;
      const std::string stem = wanted(circuit, id);
      if (stem.empty() == named) continue;
      if (named) {
        if (count[stem] == 0) count[stem] = 1;
        take(id, stem, false);
      } else {
        take(id, op_name(circuit.op(id)), true);
      }
    }
  }
  return stems;
}

}  // namespace hlsc
