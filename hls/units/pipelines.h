// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Pipelines that share ray generation, the memory and the writing of pixels. Each numbers its
// packets for itself; a shared unit has a port for each (units/port_of_each.h).
#pragma once

#include "hls/ports.h"
#include "units/port_of_each.h"

namespace dynrt {

template <class C>
inline constexpr unsigned kPipelines = C::kPipelines;
template <class C>
inline constexpr bool kHasPipelines = C::kPipelines > 1;
template <class C>
using PipelineId = hls::uint<hls::index_width(C::kPipelines)>;
template <class C>
using PipelineNumber = hls::OptionalField<kHasPipelines<C>, PipelineId<C>>;

}  // namespace dynrt
