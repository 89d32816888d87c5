// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/mailbox.h"

#include <memory>

#include "Vpacket_mailbox.h"
#include "packet_mailbox_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

using Entry = MailboxEntry<C>;

/// A packet is new, then has objects, and after the first of them triangles.
class Stimulus {
 public:
  explicit Stimulus(const Run& run) : packets_(run) {}
  void draw(Entry& e, Random& random) {
    e.packet = packets_.next(random);
    const Known known = known_[e.packet.to_u64()];
    e.clear = known == Known::kNothing || random.below(40) == 0;
    e.level = Level::from(known == Known::kTriangles && !e.clear && random.below(8) != 0);
    e.entry.matrix = number_below<C::kMatrixBits>(random, 12);
    // A leaf is reached by some ray.
    if (e.active == RayMask<C>{}) e.active = RayMask<C>(1);
  }
  void begun(const Entry& e) {
    Known& known = known_[e.packet.to_u64()];
    if (e.clear && known == Known::kNothing) {
      known = Known::kObjects;
    } else if (!e.clear) {
      known = Known::kTriangles;
    }
  }

 private:
  enum class Known : unsigned char { kNothing, kObjects, kTriangles };
  Packets packets_;
  Known known_[C::kPackets] = {};
};

void setup(Bench<Mailbox<C>>& bench, const Run& run) {
  auto stimulus = std::make_shared<Stimulus>(run);
  bench.packet<Entry>("entry", [](const Entry& e) { return e.packet.to_u64(); });
  bench.shape<Entry>("entry", [stimulus](Entry& e, Random& random) { stimulus->draw(e, random); });
  bench.begun<Entry>("entry", [stimulus](const Entry& e) { stimulus->begun(e); });
  if constexpr (kMainFirst<C>) {
    // In every other run all new rays go to a list first, and none enters the tree at once.
    const bool list = run.number % 2 == 1;
    if (list) bench.may_be_silent("start");
    bench.shape<FrameRegisters<C>>("frame", [list](FrameRegisters<C>& frame, Random&) {
      const std::uint64_t pointer = std::uint64_t{1} << (C::kAddressBits - 1);
      frame.start_node = Word::from(list ? pointer | 5 : 5);
    });
  }
}

DYNRT_COSIM(Mailbox, Mailbox<C>, packet_mailbox, setup)

}  // namespace
}  // namespace dynrt::cosim
