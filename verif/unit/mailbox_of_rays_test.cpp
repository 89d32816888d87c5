// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/mailbox_of_rays.h"

#include "Vpacket_mailbox.h"
#include "packet_mailbox_ports.h"
#include "unit/mailbox_stimulus.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<MailboxOfRays<C>>& bench, const Run& run) {
  feed_entries(bench, run);
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

DYNRT_COSIM(MailboxOfRays, MailboxOfRays<C>, packet_mailbox, setup)

}  // namespace
}  // namespace dynrt::cosim
