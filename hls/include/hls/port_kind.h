// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The kinds of ports, and the hazards of a RAM's rows: the one description that the native model,
// the lowered language, hlsc, joins and test benches share.
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

/// The accesses that may happen between the read of a row and the write that follows it.
enum class Hazard : std::uint8_t {
  kExclusive,  ///< None to the row, as one packet owns it. hlsc emits an assertion.
  kStale,      ///< A later transaction may still read the old row; the unit is right either way.
};

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
