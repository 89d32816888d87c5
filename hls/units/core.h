// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core: pipelines that trace packets, and what they share: the start of a frame, ray
// generation, the memory and, where there are several, the writing of pixels and hits. The native
// model, the Verilog top and the block diagram all come from this constructor; pipeline.h says why
// nothing waits for ever.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hls/join.h"
#include "units/bank_path.h"
#include "units/pipeline.h"
#include "units/pipelines.h"
#include "units/port_path.h"
#include "units/ray_generation.h"
#include "units/shared_bank_path.h"
#include "units/startup.h"

namespace dynrt {

/// The way to the memory.
template <class C>
using MemoryPathOf =
    std::conditional_t<kHasPort<C>, PortPath<C>,
                       std::conditional_t<kHasPipelines<C>, SharedBankPath<C>, BankPath<C>>>;

template <class C>
struct Core {
  Startup<C> startup;
  RayGeneration<C> ray_generation;
  PipelinesOf<C> pipeline;
  MemoryPathOf<C> memory;

  std::shared_ptr<hls::Fifo<uint<10>>> start;
  std::shared_ptr<hls::Fifo<uint<1>>> done;
  std::shared_ptr<FrameRegisters<C>> frame = std::make_shared<FrameRegisters<C>>();

  Core(hls::Join& join, const Banks<C>& banks) {
    name_units(join);
    join_frame(join);
    for_each_pipeline(join, [&](Pipeline<C>& p, unsigned i) {
      p.join_shading(join, port_of<kPipelines<C>>(ray_generation.position, i));
      p.join_traversal(join);
      p.join_lists(join);
      p.join_transformation(join, port_of<kPipelines<C>>(ray_generation.job, i));
      if constexpr (kHasSecondary<C>) p.join_secondary(join);
    });
    join_memory(join, banks);
    if constexpr (!C::kCounters) join.leave_out_counters();
  }

  static_assert(C::kPackets <= kResetClocks, "the reset before a frame clears no more rows");
  static_assert(C::kLines <= kFirstPacket, "start tokens have no numbers for more lines");

  /// Joins nothing yet: for tools that only list the units.
  Core() = default;

  /// Calls join.unit(name, module, unit) for every unit of configuration C, group by group. This is
  /// the only list of units: a unit that is not in it is neither joined nor lowered.
  template <class J>
  void name_units(J& join) {
    join.group("Ray generation and shading");
    join.unit("startup", "startup", startup);
    join.unit("ray_generation", "ray_generation", ray_generation);
    for_each_pipeline(join, [&](Pipeline<C>& p, unsigned) { p.name_units(join); });
    memory.name_frame_units(join);
    join.group("Memory");
    memory.name_units(join);
    for_each_pipeline(join, [&](Pipeline<C>& p, unsigned) { p.name_secondary(join); });
  }

 private:
  /// Calls act(pipeline, number); the names that a join gets in it begin with the pipeline's, if
  /// there are several.
  template <class J>
  void for_each_pipeline(J& join, auto&& act) {
    for (unsigned i = 0; i < kPipelines<C>; ++i) {
      if constexpr (kHasPipelines<C>) join.begin_names(pipeline_prefix(i));
      act(pipeline[i], i);
      join.begin_names("");
    }
  }

  void join_frame(hls::Join& join) {
    std::vector<hls::Config<FrameRegisters<C>>*> readers = {&ray_generation.frame};
    for (Pipeline<C>& p : pipeline) {
      for (auto* reader : p.frame_readers()) readers.push_back(reader);
    }
    join.config<FrameRegisters<C>>("frame", frame, readers);
    start = join.input("start", startup.number);
    done = join.output("done", ray_generation.done);
    hls::Writers<FreePacket<C>> free = {};
    for (unsigned i = 0; i < kPipelines<C>; ++i)
      free.push_back(&port_of<kPipelines<C>>(startup.free, i));
    free.push_back(&ray_generation.skipped);
    free.push_back(&memory.frame_end(pipeline).free);
    join.channel<FreePacket<C>>("free_packet", free, {&ray_generation.free},
                                kPipelines<C> * C::kPackets);
    if constexpr (kHasPipelines<C>) number_pipelines(join);
    memory.join_frame_writes(join, pipeline);
  }

  /// Gives each pipeline's units its number.
  void number_pipelines(hls::Join& join) {
    for (unsigned i = 0; i < kPipelines<C>; ++i) {
      Pipeline<C>& p = pipeline[i];
      for (hls::Config<PipelineId<C>>* number :
           {&p.shading.pipeline, &p.node_lookup.pipeline, &p.list_lookup.pipeline,
            &p.matrix_lookup.pipeline}) {
        join.constant(*number, PipelineId<C>::from(i));
      }
    }
  }

  /// The caches, and the memory behind them.
  void join_memory(hls::Join& join, const Banks<C>& banks);
};

}  // namespace dynrt

#include "units/join_memory.h"
