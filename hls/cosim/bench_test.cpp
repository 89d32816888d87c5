// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The bench itself: it passes a right unit at full speed, and names every kind of mistake of a
// wrong one.
#include "cosim/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "Vtally.h"
#include "cosim/example/tally.h"
#include "cosim/example/tally_ports.h"

namespace {

using hls::cosim::Bench;
using hls::cosim::Report;
using hls::cosim::Settings;
using hls::cosim::example::Job;
using hls::cosim::example::Tally;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

Bench<Tally> bench_of(Vtally& dut, bool packet_rule = true) {
  Bench<Tally> bench("tally", dut, [](auto& v, auto& f) { visit_ports_tally(v, f); });
  if (packet_rule) bench.packet<Job>("job", [](const Job& job) { return job.packet.to_u64(); });
  return bench;
}
Report run(unsigned bug, Settings settings = {}) {
  Vtally dut;
  dut.bug_i = static_cast<std::uint8_t>(bug);
  return bench_of(dut).run(std::move(settings));
}

TEST(Bench, PassesARightUnit) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Report report = run(0, {.seed = seed});
    EXPECT_TRUE(report.ok) << report.text;
    EXPECT_EQ(report.transactions, 10'000u);
    // 1/2 results, 3/4 copies and 1/4 rows per transaction.
    EXPECT_NEAR(static_cast<double>(report.compared), 15'000, 500);
  }
}

TEST(Bench, MeasuresTheThroughput) {
  Vtally dut;
  Bench<Tally> bench = bench_of(dut, false);
  bench.shape<Job>(
      "job", [number = 0u](Job& job, auto&) mutable { job.packet = hls::uint<4>::from(number++); });
  const Report report = bench.run({.stall_inputs = false, .stall_outputs = false});
  EXPECT_TRUE(report.ok) << report.text;
  EXPECT_GE(report.clocks, 10'000u);
  EXPECT_LE(report.clocks, 10'010u);
}

TEST(Bench, FindsThatThePacketRuleIsNeeded) {
  Vtally dut;
  const Report report = bench_of(dut, false).run({});
  EXPECT_FALSE(report.ok);
  EXPECT_THAT(report.text, HasSubstr("field total: RTL"));
}

struct Fault {
  unsigned bug;
  const char* text;
};
class Faults : public ::testing::TestWithParam<Fault> {};

TEST_P(Faults, AreFoundAndNamed) {
  const Report report = run(GetParam().bug);
  EXPECT_FALSE(report.ok);
  EXPECT_THAT(report.text, HasSubstr(GetParam().text));
  EXPECT_THAT(report.text, HasSubstr("tally: seed 1, "));
}
INSTANTIATE_TEST_SUITE_P(
    Example, Faults,
    ::testing::Values(Fault{1, "field total: RTL "}, Fault{2, ": RTL "},
                      Fault{3, "port last, write "}, Fault{4, "port result, token "},
                      Fault{5, "port result"},
                      Fault{6, "port result: the token changed before ready came, to packet = "},
                      Fault{7, "port result: valid fell before ready came"},
                      Fault{8, "no token moved for 5000 clocks; port job is not taken"},
                      Fault{9,
                            "no token moved for 5000 clocks; port last has not made write 0 of "},
                      Fault{10, "field total: RTL "}, Fault{11, "field stamp: RTL "}));

TEST(Bench, NamesFieldBothValuesAndTheTokenRead) {
  EXPECT_THAT(run(11).text,
              MatchesRegex("tally: seed 1, .*\nport result, token 0: field stamp: RTL [0-9]+ "
                           "\\(0x[0-9a-f]+\\), model [0-9]+ \\(0x[0-9a-f]+\\)\n"
                           "  transaction [0-9]+ read job: packet = [^\n]*\n"
                           "  transaction [0-9]+ read extra: [0-9]+ \\(0x[0-9a-f]+\\)"));
}

TEST(Bench, TheSeedDecidesTheRun) {
  EXPECT_EQ(run(1, {.seed = 3}).text, run(1, {.seed = 3}).text);
  EXPECT_NE(run(1, {.seed = 3}).text, run(1, {.seed = 4}).text);
}

TEST(Bench, ARunThatReachesNothingFails) {
  const Report none = run(0, {.transactions = 0});
  EXPECT_FALSE(none.ok);
  EXPECT_THAT(none.text, HasSubstr("port result gave no token in 0 transactions"));

  Vtally dut;
  Bench<Tally> bench = bench_of(dut);
  bench.shape<Job>("job", [](Job& job, auto&) { job.action = {}; });
  const Report report = bench.run({});
  EXPECT_FALSE(report.ok);
  EXPECT_THAT(report.text, HasSubstr("port last gave no token in 10000 transactions"));
}

TEST(Bench, SilentPortsMayBeNamed) {
  Vtally dut;
  Bench<Tally> bench = bench_of(dut);
  bench.shape<Job>("job", [](Job& job, auto&) { job.action = {}; });
  bench.may_be_silent("last");
  const Report report = bench.run({});
  EXPECT_TRUE(report.ok) << report.text;

  Vtally mute;
  Bench<Tally> nothing = bench_of(mute);
  nothing.shape<Job>("job",
                     [](Job& job, auto&) { job.action = hls::cosim::example::Action::kSilent; });
  for (const char* port : {"result", "copy_0", "copy_1", "last"}) nothing.may_be_silent(port);
  const Report empty = nothing.run({});
  EXPECT_FALSE(empty.ok);
  EXPECT_THAT(empty.text, HasSubstr("no token was compared"));
}

TEST(Bench, RefusesABindingOfAnotherUnit) {
  const auto refusal = [](auto visit) -> std::string {
    Vtally dut;
    try {
      const Bench<Tally> bench("tally", dut, visit);
    } catch (const std::logic_error& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(refusal([](auto& v, auto& f) {
              visit_ports_tally(v, f);
              f.in("extra", 8, v.extra_valid_i, v.extra_ready_o, v.extra_data_i);
            }),
            "tally: port extra is 8 bits, 1 rows, latency 0 in Verilog, 7 bits, 1 rows, latency 0 "
            "in the model");
  EXPECT_EQ(refusal([](auto& v, auto& f) {
              visit_ports_tally(v, f);
              f.config("more", 8, v.offset_i);
            }),
            "tally: the Verilog has a port more, the unit has none");
  EXPECT_EQ(refusal([](auto&, auto&) {}), "tally: the Verilog has no port job");
}

TEST(Bench, RefusesUnknownPorts) {
  Vtally dut;
  Bench<Tally> bench = bench_of(dut);
  EXPECT_THROW(bench.shape<Job>("jobs", {}), std::logic_error);
  EXPECT_THROW(bench.shape<bool>("job", {}), std::logic_error);
}

}  // namespace
