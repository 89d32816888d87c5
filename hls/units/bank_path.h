// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Bank path: the way of a core to six banks of SRAM (thesis chapter 7). One unit serves the misses
// of all caches from banks 0 to 2; the shading of the only pipeline writes banks 3 to 5 itself.
#pragma once

#include <array>
#include <string>

#include "hls/join.h"
#include "units/banks.h"
#include "units/memory_interface.h"
#include "units/pipeline.h"
#include "units/startup.h"

namespace dynrt {

template <class C>
using PipelinesOf = std::array<Pipeline<C>, kPipelines<C>>;

template <class C>
struct BankPath {
  MemoryInterface<C> memory_interface;

  static constexpr auto kMissFifo = hls::WriterFifo::kHoldsAll;

  /// Units that end a packet's shading, in the group of the shading.
  template <class J>
  void name_frame_units(J& /*join*/) {}
  template <class J>
  void name_units(J& join) {
    join.unit("memory_interface", "memory_interface", memory_interface);
  }
  /// The unit that gives lines to the caches.
  auto& line_writer() { return memory_interface; }
  /// The unit that frees packets, after their last pixel.
  static auto& frame_end(PipelinesOf<C>& pipelines) { return pipelines[0].shading; }

  void join_frame_writes(hls::Join& /*join*/, PipelinesOf<C>& /*pipelines*/) {}
  void join_misses(hls::Join& join, const hls::Writers<MemoryRequest<C>>& misses,
                   const Banks<C>& banks, PipelinesOf<C>& /*pipelines*/, Startup<C>& /*startup*/) {
    if constexpr (kSlowMemory<C>) {
      join.repeat("memory_request", misses, memory_interface.request);
    } else {
      join.channel<MemoryRequest<C>>("memory_request", misses, {&memory_interface.request});
    }
    for (unsigned i = 0; i < kSceneBanks; ++i) {
      join.bank("bank" + std::to_string(i), memory_interface.bank[i], banks.scene[i]);
    }
    join.depends_on_order({"memory_request", "memory_interface"});
  }
  void join_frame_banks(hls::Join& join, const Banks<C>& banks, PipelinesOf<C>& pipelines) {
    join_written_banks(join, banks, frame_end(pipelines));
  }

 protected:
  static void join_written_banks(hls::Join& join, const Banks<C>& banks, auto& writer) {
    for (unsigned i = 0; i < banks.out.size(); ++i) {
      join.bank("bank" + std::to_string(kFrameBank + i), writer.bank[i], banks.out[i]);
    }
  }
};

}  // namespace dynrt
