// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// One random netlist, lowered and Verilated, against its interpreter. Compiled once per SEED.
#include <gtest/gtest.h>
#include <verilated.h>

#include "cosim/bench.h"
#include "cosim/netlist_model.h"
#include "cosim/random_netlist.h"

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define VMODULE JOIN(Vrandom_, SEED)
#define VISIT JOIN(visit_ports_random_, SEED)
#include VERILATED_HEADER
#include PORTS_HEADER

namespace {

/// The tokens of the first In are numbered, so that no transaction meets another one's row.
void run(hls::cosim::Settings settings) {
  const hlsc::Netlist netlist = hlsc::random_netlist(SEED);
  VerilatedContext context;
  context.randReset(0);  // the interpreter's RAMs hold zeros at first
  VMODULE top(&context);
  hls::cosim::ModelBench bench(
      "random netlist", top, [](auto& v, auto& f) { VISIT(v, f); },
      std::make_unique<hlsc::NetlistModel>(netlist));
  bench.shape<hls::cosim::TokenBits>("in",
                                     [number = 0u](hls::cosim::TokenBits& token, auto&) mutable {
                                       constexpr std::uint32_t kMask = (1u << hlsc::kIdWidth) - 1;
                                       token[0] = (token[0] & ~kMask) | (number++ & kMask);
                                     });
  for (const char* port : {"some", "hits"}) bench.may_be_silent(port);
  settings.transactions = 2000;
  settings.drain = 400;
  const hls::cosim::Report report = bench.run(settings);
  EXPECT_TRUE(report.ok) << report.text;
  EXPECT_EQ(report.transactions, 2000u);
  EXPECT_GE(report.compared, 2000u);
}

}  // namespace

#define SUITE JOIN(Random, SEED)
TEST(SUITE, EqualsInterpreter) { run({.stall_inputs = false, .stall_outputs = false}); }
TEST(SUITE, EqualsInterpreterWithInputStalls) { run({.seed = 2, .stall_outputs = false}); }
TEST(SUITE, EqualsInterpreterWithOutputStalls) { run({.seed = 3, .stall_inputs = false}); }
TEST(SUITE, EqualsInterpreterWithStallsAtBothEnds) { run({.seed = 4}); }
