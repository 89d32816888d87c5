// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The kinds of ports, and the hazards of a RAM between units: the one description that the native
// model, the lowered language, hlsc, joins and test benches share.
#pragma once

#include <cstdint>

namespace hls {

/// A member through which a transaction reads or writes.
enum class PortKind : std::uint8_t {
  kIn,            ///< channel, reading end
  kOut,           ///< channel, writing end
  kRam,           ///< RAM inside the unit, data one clock after the address
  kRegisterFile,  ///< RAM inside the unit, read and written in one stage
  kRamWrite,      ///< writing end of a RAM outside the unit
  kRamRead,       ///< reading end of a RAM outside the unit
  kConfig,        ///< value that does not change
};

/// Whether a row may be read in the clock that writes it: a read-write collision.
enum class Hazard : std::uint8_t {
  kExclusive,  ///< Never, as one packet owns the row. The RAM asserts that.
  kTorn,       ///< It may. The lowest bit of the row marks it; the other bits are then undefined.
};

/// Whether a RAM asks for block RAM even if it has few rows, as an FPGA runs out of LUTs first.
/// Synthesis decides for the others.
constexpr bool asks_for_block_ram(unsigned width, unsigned rows) {
  return width >= 64 && rows >= 32;
}

/// The properties of a port that its type gives.
struct PortInfo {
  PortKind kind = PortKind::kIn;
  unsigned width = 0;    ///< bits of a token, a row or a value
  unsigned rows = 1;     ///< of a RAM
  unsigned latency = 0;  ///< clocks from a RAM's address to its data
  bool operator==(const PortInfo&) const = default;
};

/// The effect of one call on a port, for hlsc: the annotation of the functions of
/// hls/lowered/hls/ports.h.
enum class PortAccess : std::uint8_t {
  kGetLeaf,      ///< a leaf of a token or a configuration value is read
  kGetRowLeaf,   ///< a leaf of a row is read
  kPutLeaf,      ///< a leaf of the token or row that is about to be written
  kCommitToken,  ///< the leaves put before are one token
  kCommitRow,    ///< the leaves put before are one row
};

}  // namespace hls
