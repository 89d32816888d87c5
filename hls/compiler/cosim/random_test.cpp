// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One random netlist, lowered and Verilated, against its interpreter. Compiled once per SEED.
#include "cosim/bench.h"
#include "cosim/random_netlist.h"

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define VMODULE JOIN(Vrandom_, SEED)
#define VISIT JOIN(visit_ports_random_, SEED)
#include VERILATED_HEADER
#include PORTS_HEADER

namespace {

void run_with(unsigned stall_in, unsigned stall_out, std::uint32_t bench_seed) {
  const hlsc::Netlist netlist = hlsc::random_netlist(SEED);
  hlsc::Bench bench(netlist, bench_seed);
  VerilatedContext context;
  context.randReset(0);  // the interpreter's RAMs hold zeros at first
  VMODULE top(&context);
  auto visitor = bench.visitor();
  VISIT(top, visitor);
  bench.token = [&](unsigned port, unsigned i) {
    hlsc::Bits token = bench.random_bits(netlist.ports[port].width);
    for (unsigned bit = 0; port == 0 && bit < hlsc::kIdWidth; ++bit)
      token.set(bit, (i >> bit & 1) != 0);
    return token;
  };
  bench.run(2000, [&top] { top.eval(); }, {stall_in, stall_out});
  EXPECT_GE(bench.compared, 2000u);
}

}  // namespace

#define SUITE JOIN(Random, SEED)
TEST(SUITE, EqualsInterpreter) { run_with(1000, 1000, 1); }
TEST(SUITE, EqualsInterpreterWithInputStalls) { run_with(2, 1000, 2); }
TEST(SUITE, EqualsInterpreterWithOutputStalls) { run_with(1000, 2, 3); }
TEST(SUITE, EqualsInterpreterWithStallsAtBothEnds) { run_with(3, 3, 4); }
