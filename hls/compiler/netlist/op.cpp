// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "netlist/op.h"

#include <array>

namespace hlsc {
namespace {

struct Facts {
  const char* name;
  int operands;
};

// In the order of the enum.
constexpr std::array<Facts, 25> kFacts{{
    {"const", 0}, {"token", 0}, {"config", 0},  {"register", 0}, {"row", 0},
    {"add", 2},   {"sub", 2},   {"addsub", 3},  {"mul", 2},      {"div", 2},
    {"and", 2},   {"or", 2},    {"xor", 2},     {"not", 1},      {"shl", 2},
    {"shr", 2},   {"asr", 2},   {"eq", 2},      {"lt", 2},       {"slt", 2},
    {"mux", 3},   {"slice", 1}, {"concat", -1}, {"sext", 1},     {"clz", 1},
}};

const Facts& facts(Op op) { return kFacts.at(static_cast<std::size_t>(op)); }

}  // namespace

const char* op_name(Op op) { return facts(op).name; }
int operand_count(Op op) { return facts(op).operands; }
bool is_source(Op op) { return op <= Op::kRow; }
bool is_wiring(Op op) { return op == Op::kSlice || op == Op::kConcat || op == Op::kSExt; }

bool is_ram(PortKind kind) {
  return kind == PortKind::kRam || kind == PortKind::kRegisterFile || kind == PortKind::kRamWrite ||
         kind == PortKind::kRamRead;
}

unsigned address_width(unsigned rows) {
  unsigned bits = 1;
  while ((1ull << bits) < rows) ++bits;
  return bits;
}

}  // namespace hlsc
