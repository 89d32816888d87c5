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

/// A part of each unit that says in its tokens which pipeline it belongs to: the only one, or the
/// one whose number the core gives to the unit.
template <class C>
struct OnlyPipeline {
  HLS_NO_PORTS
  static PipelineNumber<C> number() { return {}; }
};
template <class C>
struct NumberedPipeline {
  hls::Config<PipelineId<C>> pipeline;
  HLS_PORTS(pipeline)
  PipelineNumber<C> number() const { return pipeline.get(); }
};
template <class C>
using PipelineOf = std::conditional_t<kHasPipelines<C>, NumberedPipeline<C>, OnlyPipeline<C>>;

}  // namespace dynrt
