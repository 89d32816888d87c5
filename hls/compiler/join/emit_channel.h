// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One channel of a Verilog top: an arbiter where several units write it, a repeater where its
// tokens are jobs that say how often they are sent, a fork with queues where several units read it.
#pragma once

#include "hls/join_record.h"
#include "join/top_text.h"

namespace hlsc {

/// Throws std::invalid_argument of a fork that lacks the number of tokens that it can hold.
void emit_channel(const hls::JoinRecord& join, const hls::ChannelRecord& channel, TopText& top);

}  // namespace hlsc
