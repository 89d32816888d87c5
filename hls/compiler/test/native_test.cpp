// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The front end alone, and with the passes behind it: sample units, natively and as interpreted
// netlists, on random tokens.
#include "backend.h"
#include "frontend/read_unit.h"
#include "test/compare.h"
#include "test/units/accumulator.h"
#include "test/units/arithmetic.h"
#include "test/units/arrays.h"
#include "test/units/floats.h"
#include "test/units/intrinsics.h"
#include "test/units/loops.h"
#include "test/units/mailbox.h"
#include "test/units/optional.h"
#include "test/units/parts.h"
#include "test/units/rams.h"
#include "test/units/routing.h"
#include "test/units/switches.h"

namespace hlsc::test {
namespace {

template <class Unit>
void compare_sample(const std::string& type, const std::string& name, unsigned transactions) {
  UnitSource source;
  source.unit = "samples::" + type;
  source.header = "test/units/" + name + ".h";
  source.module = name;
  const std::string hls = HLSC_TEST_HLS;
  source.folders = {hls + "/lowered", hls + "/include", hls + "/compiler"};
  const Netlist netlist = read_unit(source).netlist;
  compare_unit<Unit>(netlist, transactions, 1);
  Options options;
  options.delay = load_delay_model(hls + "/compiler/delay/ecp5.json");
  compare_unit<Unit>(optimise(netlist, options), transactions, 2);
}

TEST(Native, Mailbox) { compare_sample<samples::Mailbox>("Mailbox", "mailbox", 5000); }
TEST(Native, Optional) {
  compare_sample<samples::Optional<true>>("Optional<true>", "optional", 5000);
  compare_sample<samples::Optional<false>>("Optional<false>", "optional", 5000);
}
TEST(Native, Parts) { compare_sample<samples::Parts>("Parts", "parts", 5000); }
TEST(Native, Accumulator) {
  compare_sample<samples::Accumulator>("Accumulator", "accumulator", 5000);
}
TEST(Native, Arithmetic) { compare_sample<samples::Arithmetic>("Arithmetic", "arithmetic", 5000); }
TEST(Native, Arrays) { compare_sample<samples::Arrays>("Arrays", "arrays", 5000); }
TEST(Native, Intrinsics) { compare_sample<samples::Intrinsics>("Intrinsics", "intrinsics", 20000); }
TEST(Native, Switches) { compare_sample<samples::Switches>("Switches", "switches", 5000); }
TEST(Native, Routing) { compare_sample<samples::Routing>("Routing", "routing", 5000); }
TEST(Native, Loops) { compare_sample<samples::Loops>("Loops", "loops", 5000); }
TEST(Native, Rams) { compare_sample<samples::Rams>("Rams", "rams", 5000); }
TEST(Native, Floats) { compare_sample<samples::Floats>("Floats", "floats", 20000); }

}  // namespace
}  // namespace hlsc::test
