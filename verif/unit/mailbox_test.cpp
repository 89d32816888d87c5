// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/mailbox.h"

#include "Vpacket_mailbox.h"
#include "packet_mailbox_ports.h"
#include "unit/mailbox_stimulus.h"

namespace dynrt::cosim {
namespace {

void setup(Bench<Mailbox<C>>& bench, const Run& run) { feed_entries(bench, run); }

DYNRT_COSIM(Mailbox, Mailbox<C>, packet_mailbox, setup)

}  // namespace
}  // namespace dynrt::cosim
