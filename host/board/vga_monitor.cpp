// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/vga_monitor.h"

namespace dynrt::host {

void VgaMonitor::sample(bool clock, bool hsync, bool vsync, bool visible, std::uint32_t colour) {
  ++clocks_;
  const bool rises = clock && !clock_;
  clock_ = clock;
  if (!rises) return;
  meter_.take({colour, hsync, vsync, visible, clocks_});
  clocks_ = 0;
}

}  // namespace dynrt::host
