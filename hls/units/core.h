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
#include "units/banks.h"
#include "units/frame_writer.h"
#include "units/memory_answer.h"
#include "units/memory_fill.h"
#include "units/memory_gather.h"
#include "units/memory_interface.h"
#include "units/memory_lookup.h"
#include "units/memory_write.h"
#include "units/pipeline.h"
#include "units/pipelines.h"
#include "units/ray_generation.h"
#include "units/startup.h"

namespace dynrt {

template <class C>
struct Core {
  /// Whether several pipelines write to the banks of pixels and hits.
  static constexpr bool kSharesBanks = kHasPipelines<C> && !kHasPort<C>;

  Startup<C> startup;
  RayGeneration<C> ray_generation;
  std::array<Pipeline<C>, kPipelines<C>> pipeline;
  hls::OptionalPort<!kHasPort<C>, MemoryInterface<C>> memory_interface;
  hls::OptionalPort<kHasPort<C>, MemoryLookup<C>> memory_lookup;
  hls::OptionalPort<kHasPort<C>, MemoryGather<C>> memory_gather;
  hls::OptionalPort<kHasPort<C>, MemoryFill<C>> memory_fill;
  hls::OptionalPort<kHasPort<C>, MemoryAnswer<C>> memory_answer;
  hls::OptionalPort<kHasPort<C>, MemoryWrite<C>> memory_write;
  hls::OptionalPort<kSharesBanks, FrameWriter<C>> frame_writer;

  std::shared_ptr<hls::Fifo<uint<10>>> start;
  std::shared_ptr<hls::Fifo<uint<1>>> done;
  /// Of the memory's port, if there is one.
  std::shared_ptr<hls::Fifo<PortRead<C>>> read;
  std::shared_ptr<hls::Fifo<PortBeat<C>>> beat;
  std::shared_ptr<hls::Fifo<PortWrite<C>>> write;
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
    if constexpr (kSharesBanks) join.unit("frame_writer", "frame_writer", frame_writer);
    join.group("Memory");
    if constexpr (kHasPort<C>) {
      join.unit("memory_lookup", "memory_lookup", memory_lookup);
      join.unit("memory_gather", "memory_gather", memory_gather);
      join.unit("memory_fill", "memory_fill", memory_fill);
      join.unit("memory_answer", "memory_answer", memory_answer);
      join.unit("memory_write", "memory_write", memory_write);
    } else {
      join.unit("memory_interface", "memory_interface", memory_interface);
    }
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
    free.push_back(&frame_end().free);
    join.channel<FreePacket<C>>("free_packet", free, {&ray_generation.free},
                                kPipelines<C> * C::kPackets);
    if constexpr (kHasPipelines<C>) join_pipelines(join);
  }

  /// What pipelines share beyond ray generation and memory, and each one's number.
  void join_pipelines(hls::Join& join) {
    for (unsigned i = 0; i < kPipelines<C>; ++i) {
      Pipeline<C>& p = pipeline[i];
      for (hls::Config<PipelineId<C>>* number :
           {&p.shading.pipeline, &p.node_lookup.pipeline, &p.list_lookup.pipeline,
            &p.matrix_lookup.pipeline}) {
        join.constant(*number, PipelineId<C>::from(i));
      }
    }
    if constexpr (kSharesBanks) {
      join.channel<FrameWrite<C>>("frame_write", writes(&Shading<C>::write), {&frame_writer.write});
    }
  }

  /// What the pipelines' shading writes to the unit that they share.
  template <class Token>
  hls::Writers<Token> writes(hls::Out<Token> Shading<C>::* port) {
    hls::Writers<Token> writers = {};
    for (Pipeline<C>& p : pipeline) writers.push_back(&(p.shading.*port));
    return writers;
  }

  /// The unit that frees packets, after their last pixel.
  auto& frame_end() {
    if constexpr (kHasPort<C>) {
      return memory_write;
    } else if constexpr (kHasPipelines<C>) {
      return frame_writer;
    } else {
      return pipeline[0].shading;
    }
  }

  /// The caches, and the memory behind them.
  void join_memory(hls::Join& join, const Banks<C>& banks);
  /// The misses of the caches go to banks of SRAM or to the port.
  void join_banks(hls::Join& join, const hls::Writers<MemoryRequest<C>>& misses,
                  const Banks<C>& banks);
  void join_port(hls::Join& join, hls::Writers<MemoryRequest<C>> misses);
  /// The unit that gives lines to the caches.
  auto& line_writer() {
    if constexpr (kHasPort<C>) {
      return memory_answer;
    } else {
      return memory_interface;
    }
  }
};

}  // namespace dynrt

#include "units/join_memory.h"
