// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/traversal_slice.h"

#include <bitset>
#include <memory>

#include "Vtraversal_slice.h"
#include "traversal_slice_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

constexpr unsigned kStackRows = 1u << StackPointer<C>::kWidth;  ///< of a packet and level

/// An interval is initialised before it is used, and a far end is pushed before it is popped.
class Stimulus {
 public:
  explicit Stimulus(const Run& run) : packets_(run) {}
  void draw(Step<C>& s, Random& random) {
    StepContext<C>& c = s.context;
    c.packet = packets_.next(random);
    // Often one of a few rows, so that they are pushed to and popped from in quick succession.
    c.stack = number_below<StackPointer<C>::kWidth>(random, random.below(2) ? 4 : kStackRows);
    c.update = any_of<IntervalUpdate>(random, 5);
    const State& state = at(c);
    if (!state.initialised || random.below(64) == 0) c.update = IntervalUpdate::kInit;
    if (c.update == IntervalUpdate::kPop && !state.pushed[c.stack.to_u64()]) {
      c.update = IntervalUpdate::kClipFarPush;
    }
  }
  void begun(const Step<C>& s) {
    State& state = at(s.context);
    state.initialised = true;
    if (s.context.update == IntervalUpdate::kClipFarPush) {
      state.pushed[s.context.stack.to_u64()] = true;
    }
  }

 private:
  struct State {
    bool initialised = false;
    std::bitset<kStackRows> pushed;
  };
  State& at(const StepContext<C>& c) { return states_[level_of(c.level)][c.packet.to_u64()]; }
  Packets packets_;
  State states_[2][C::kPackets];
};

void setup(Bench<TraversalSlice<C>>& bench, const Run& run) {
  auto stimulus = std::make_shared<Stimulus>(run);
  bench.packet<Step<C>>("step_in", [](const Step<C>& s) { return s.context.packet.to_u64(); });
  bench.shape<Step<C>>("step_in",
                       [stimulus](Step<C>& s, Random& random) { stimulus->draw(s, random); });
  bench.begun<Step<C>>("step_in", [stimulus](const Step<C>& s) { stimulus->begun(s); });
}

DYNRT_COSIM(TraversalSlice, TraversalSlice<C>, traversal_slice, setup)

}  // namespace
}  // namespace dynrt::cosim
