// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/light_rays.h"

#include <memory>

#include "Vsecondary_rays.h"
#include "secondary_rays_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// A packet's primary rays are shaded first; afterwards those of any kind may be.
class Stimulus {
 public:
  explicit Stimulus(const Run& run) : packets_(run) {}
  void draw(DerivationEvent<C>& d, Random& random) {
    d.packet = packets_.next(random);
    const bool known = known_[d.packet.to_u64()];
    d.shaded = true;
    d.kind = known ? any_of<RayKind>(random, 2) : RayKind::kPrimary;
  }
  void begun(const DerivationEvent<C>& d) { known_[d.packet.to_u64()] = true; }

 private:
  Packets packets_;
  bool known_[C::kPackets] = {};
};

void setup(Bench<LightRays<C>>& bench, const Run& run) {
  auto stimulus = std::make_shared<Stimulus>(run);
  bench.packet<DerivationEvent<C>>("derive",
                                   [](const DerivationEvent<C>& d) { return d.packet.to_u64(); });
  bench.shape<DerivationEvent<C>>(
      "derive", [stimulus](DerivationEvent<C>& d, Random& random) { stimulus->draw(d, random); });
  bench.begun<DerivationEvent<C>>("derive",
                                  [stimulus](const DerivationEvent<C>& d) { stimulus->begun(d); });
  bench.shape<FrameRegisters<C>>("frame", [](FrameRegisters<C>& frame, Random& random) {
    frame.lights = Word::from(1 + random.below(C::kLights));
  });
}

DYNRT_COSIM(LightRays, LightRays<C>, secondary_rays, setup)

}  // namespace
}  // namespace dynrt::cosim
