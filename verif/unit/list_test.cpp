// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/list.h"

#include <memory>

#include "Vlist.h"
#include "list_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

using Job = ListJob<C>;

/// A list is begun before it goes on.
class Stimulus {
 public:
  explicit Stimulus(const Run& run) : packets_(run) {}
  void draw(Job& job, Random& random) {
    job.packet = packets_.next(random);
    job.first = !begun_[level_of(job.level)][job.packet.to_u64()] || random.below(5) == 0;
  }
  void begun(const Job& job) { begun_[level_of(job.level)][job.packet.to_u64()] = true; }

 private:
  Packets packets_;
  bool begun_[2][C::kPackets] = {};
};

void setup(Bench<List<C>>& bench, const Run& run) {
  auto stimulus = std::make_shared<Stimulus>(run);
  bench.packet<Job>("job", [](const Job& job) { return job.packet.to_u64(); });
  bench.shape<Job>("job", [stimulus](Job& job, Random& random) { stimulus->draw(job, random); });
  bench.begun<Job>("job", [stimulus](const Job& job) { stimulus->begun(job); });
}

DYNRT_COSIM(List, List<C>, list, setup)

}  // namespace
}  // namespace dynrt::cosim
