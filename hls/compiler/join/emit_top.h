// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// From the record of a join to its Verilog top, the top's header and a description as JSON.
#pragma once

#include <string>

#include "hls/join_record.h"

namespace hlsc {

inline constexpr unsigned kMaxCounters =
    256;  ///< of rtl/lib/hls_counters.v, whose address has 8 bits

/// A Verilog-2005 module `name` that instantiates every unit and connects them through rtl/lib.
/// Throws std::invalid_argument that names an unconnected port, or a fork without a bound to a unit
/// that also needs other tokens, or more than kMaxCounters counters. A top without counters still
/// has the ports that read them; they read zero.
std::string emit_top(const hls::JoinRecord& join, const std::string& name);

/// The fields of the values set from outside, for hand-written Verilog around the top to include:
/// `NAME_VALUE_BITS, the width of each, and `NAME_VALUE_FIELD, of each field the lowest bit.
std::string emit_header(const hls::JoinRecord& join, const std::string& name);

/// Units, channels, RAMs, banks and counters, for the host, the block diagram and users' scripts.
std::string emit_json(const hls::JoinRecord& join, const std::string& name);

}  // namespace hlsc
