// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/collect_hits.h"

#include <memory>

#include "Vcollect_hits.h"
#include "collect_hits_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

using Candidate = HitCandidate<C>;

std::uint64_t row(const Candidate& in) { return in.packet.to_u64() * kRays<C> + in.ray.to_u64(); }

/// A ray is new before it has hits; some hits are equally far.
class Stimulus {
 public:
  explicit Stimulus(const Run& run) : packets_(run) {}
  void draw(Candidate& in, Random& random) {
    in.packet = packets_.next(random);
    in.reset = !known_[row(in)] || random.below(16) == 0;
    in.hit = in.hit && !in.reset;
    if (random.below(2) == 0) in.t = C::Real::from_uint(number_below<4>(random, 16));
  }
  void begun(const Candidate& in) { known_[row(in)] = true; }

 private:
  Packets packets_;
  bool known_[C::kPackets * kRays<C>] = {};
};

void setup(Bench<CollectHits<C>>& bench, const Run& run) {
  auto stimulus = std::make_shared<Stimulus>(run);
  bench.packet<Candidate>("candidate", row);
  bench.shape<Candidate>("candidate",
                         [stimulus](Candidate& in, Random& random) { stimulus->draw(in, random); });
  bench.begun<Candidate>("candidate", [stimulus](const Candidate& in) { stimulus->begun(in); });
}

DYNRT_COSIM(CollectHits, CollectHits<C>, collect_hits, setup)

}  // namespace
}  // namespace dynrt::cosim
