// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/shader.h"

#include <memory>

#include "Vshader.h"
#include "shader_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

using Job = Repeated<ShadeJob<C>>;

std::uint64_t row(const Job& j) {
  return j.job.packet.to_u64() * kRays<C> + j.index.to_u64() % kRays<C>;
}

/// A ray is a primary one first.
class Stimulus {
 public:
  explicit Stimulus(const Run& run) : packets_(run) {}
  void draw(Job& j, Random& random) {
    j.job.packet = packets_.next(random);
    j.index = number_below<kRayBits<C> + 2>(random, kRays<C>);
    j.last = j.index == RepeatCount<C>(kRays<C> - 1);
    j.job.kind = known_[row(j)] ? any_of<RayKind>(random, 3) : RayKind::kPrimary;
  }
  void begun(const Job& j) { known_[row(j)] = true; }

 private:
  Packets packets_;
  bool known_[C::kPackets * kRays<C>] = {};
};

void setup(Bench<Shader<C>>& bench, const Run& run) {
  auto stimulus = std::make_shared<Stimulus>(run);
  bench.packet<Job>("job", row);
  bench.shape<Job>("job", [stimulus](Job& j, Random& random) { stimulus->draw(j, random); });
  bench.begun<Job>("job", [stimulus](const Job& j) { stimulus->begun(j); });
  bench.shape<FrameRegisters<C>>("frame", [](FrameRegisters<C>& frame, Random& random) {
    frame.ambient = Word::from(random.below(257));
  });
}

DYNRT_COSIM(Shader, Shader<C>, shader, setup)

}  // namespace
}  // namespace dynrt::cosim
