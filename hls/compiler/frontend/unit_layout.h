// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The unit's members, read from the debug info of its type: a member whose class derives from
// hls::lowered::Port is a port, everything else is broken up into registers, one per scalar.
// Structs give name_field, arrays name_0, name_1, ...; a class with one member only (uint<W>) gives
// no name of its own.
#pragma once

#include <llvm/IR/Module.h>

#include <cstdint>
#include <string>
#include <vector>

#include "frontend/source_lines.h"
#include "netlist/netlist.h"

namespace hlsc {

struct PortMember {
  Port port;
  std::uint64_t offset = 0;  ///< bytes from the unit's start
};

struct RegisterMember {
  std::string name;
  std::uint64_t offset = 0;   ///< bytes from the unit's start
  unsigned storage_bits = 0;  ///< of the integer in memory
  unsigned width = 0;         ///< of the value
  bool is_signed = false;     ///< the way storage extends the value
  SourceLine where;
};

struct UnitLayout {
  std::vector<PortMember> ports;
  std::vector<RegisterMember> registers;
  std::string source;  ///< the file that defines the unit
};

/// Reads the type of the global `hls_initial`; throws Error for a member that cannot be a register.
UnitLayout read_layout(const llvm::Module& module, const SourceLines& lines);

}  // namespace hlsc
