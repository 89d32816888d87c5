// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/scan_out.h"

#include "Vscan_out.h"
#include "scan_out_ports.h"
#include "unit/cosimulate.h"

namespace dynrt::cosim {
namespace {

/// A mode so small that a run has many vertical blanks, now and then restarted.
void setup(Bench<ScanOut<C>>& bench, const Run&) {
  bench.shape<uint<1>>(
      "tick", [](uint<1>& first, Random& random) { first = uint<1>(random.below(5000) == 0); });
  bench.shape<ScanConfig>("config", [](ScanConfig& c, Random& random) {
    const auto add = [&random](uint<32> to, std::uint64_t most) {
      return Word::from(to.to_u64() + random.below(most + 1));
    };
    c.width = add(1, 40);
    c.height = add(1, 20);
    c.left = add(0, 20);
    c.top = add(0, 10);
    c.hdisplay = add(2, 40);
    c.hsync_start = add(c.hdisplay, 5);
    c.hsync_end = add(c.hsync_start, 5);
    c.htotal = add(c.hsync_end, 5);
    c.vdisplay = add(1, 20);
    c.vsync_start = add(c.vdisplay, 3);
    c.vsync_end = add(c.vsync_start, 3);
    c.vtotal = add(Word::from(c.vsync_end.to_u64() + 1), 3);
  });
}

DYNRT_COSIM(ScanOut, ScanOut<C>, scan_out, setup)

}  // namespace
}  // namespace dynrt::cosim
