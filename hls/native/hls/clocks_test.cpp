// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Clocks of a join whose units have schedules.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "hls/join_test_units.h"

namespace {

using hls::uint;
using hls::testing::Add;
using hls::testing::Byte;
using hls::testing::CountTorn;
using hls::testing::Job;
using hls::testing::List;
using hls::testing::LookTorn;
using hls::testing::Pair;
using hls::testing::Receive;
using hls::testing::Send;
using hls::testing::values;
using hls::testing::WriteTorn;

TEST(Clocks, TokensTakeTheStagesOfTheirUnitsAndMeetOneAtATime) {
  Add left, right, last;
  hls::Join join({{"add", {.stages = 3, .room = 6}}, {"slow_add", {.stages = 7, .room = 10}}});
  join.unit("left", "add", left);
  join.unit("right", "slow_add", right);
  join.unit("last", "add", last);
  auto one = std::make_shared<Byte>(Byte(1));
  join.config("one", one, std::vector{&left.value, &right.value, &last.value});
  auto to_left = join.input("to_left", left.in);
  auto to_right = join.input("to_right", right.in);
  join.channel<Byte>("both", {&left.out, &right.out}, {&last.in});
  auto out = join.output("out", last.out);
  // The right's token comes to the arbiter in clock 9, as one from the left does, which goes first:
  // the left has kept the grant since it sent its first. Then the grant goes to the right.
  for (const unsigned clock : {0, 6, 6}) {
    to_left->push(Byte(10));
    join.arrives("to_left", clock);
  }
  to_right->push(Byte(20));
  join.arrives("to_right", 2);
  join.run_clocks();
  EXPECT_EQ(values(*out), (List{12, 12, 22, 12}));
  EXPECT_EQ(join.first_of("out"), 0u + 3 + 1 + 3);
  EXPECT_EQ(join.counters().at("last.transactions"), 4u);
  EXPECT_EQ(join.counters().at("both.tokens"), 4u);
}

TEST(Clocks, AWatcherKnowsTheClockOfEachTransaction) {
  Add add;
  hls::Join join(hls::ModuleSchedules{{"add", {.stages = 4, .room = 8}}});
  join.unit("add", "add", add);
  const auto in = join.input("in", add.in);
  join.constant(add.value, Byte(1));
  const auto out = join.output("out", add.out);
  List clocks;
  join.watch([&](std::size_t, std::uint64_t clock) { clocks.push_back(clock); });
  for (const std::uint64_t clock : {3, 4, 9}) {
    in->push(Byte(1));
    join.arrives("in", clock);
  }
  join.run_clocks();
  EXPECT_EQ(clocks, (List{3, 4, 9}));
}

TEST(Clocks, AUnitWithoutRoomWaits) {
  Send send;
  Receive receive;
  hls::Join join({{"send", {.stages = 1, .room = 4}}, {"receive", {.stages = 1, .room = 4}}});
  join.unit("send", "send", send);
  join.unit("receive", "receive", receive);
  auto in = join.input("in", send.in);
  join.repeat("job", hls::Writers{&send.out}, receive.in);
  auto out = join.output("out", receive.out);
  for (unsigned i = 0; i < 6; ++i) {
    in->push(Job{uint<4>(0), uint<6>::from(i)});
    join.arrives("in", 0);
  }
  join.run_clocks();
  // Nobody takes what comes out, so four tokens wait there, four before it, and it all stands.
  EXPECT_EQ(out->size(), 4u);
  EXPECT_EQ(join.counters().at("receive.transactions"), 4u);
  EXPECT_EQ(join.counters().at("send.transactions"), 6u);
  EXPECT_GT(join.counters().at("receive.stalls"), 0u);
}

/// Stalls of a writer with room for two tokens, of which none is taken before clock 20.
std::uint64_t stalls_of_a_writer(hls::WriterFifo fifo) {
  Add add;
  Pair pair;
  hls::Join join({{"add", {.stages = 1, .room = 2}}, {"pair", {.stages = 1, .room = 12}}});
  join.unit("add", "add", add);
  join.unit("pair", "pair", pair);
  join.constant(add.value, Byte(1));
  auto in = join.input("in", add.in);
  auto late = join.input("late", pair.in[0]);
  join.channel<Byte>("sums", hls::Writers(&add.out, fifo), {&pair.in[1]}, 12);
  auto out = join.output("out", pair.out);
  for (unsigned i = 0; i < 6; ++i) {
    in->push(Byte::from(i));
    join.arrives("in", 0);
    late->push(Byte(0));
    join.arrives("late", 20);
  }
  join.run_clocks();
  EXPECT_EQ(values(*out), (List{256, 512, 768, 1024, 1280, 1536}));
  return join.counters().at("add.stalls");
}

TEST(Clocks, OnlyAShortFifoMakesItsWriterWait) {
  EXPECT_EQ(stalls_of_a_writer(hls::WriterFifo::kHoldsAll), 0u);
  EXPECT_GT(stalls_of_a_writer(hls::WriterFifo::kShort), 0u);
}

/// Notes waits and the most tokens as sentences and sums.
struct Notes : hls::ClockWatch {
  struct Fill {
    std::uint64_t tokens = 0, clocks = 0, last = 0;
  };
  void waited(std::size_t unit, std::size_t fifo, hls::Lack lack, std::uint64_t from,
              std::uint64_t to) override {
    waits[{unit, fifo, lack}] += to - from;
    all[unit] += to - from;
  }
  void passed(std::size_t fifo, std::uint64_t from, std::uint64_t to) override {
    EXPECT_GE(to, from);
    EXPECT_GE(to, fills[fifo].last);
    ++fills[fifo].tokens;
    fills[fifo].clocks += to - from + 1;
    fills[fifo].last = to;
  }
  std::map<std::tuple<std::size_t, std::size_t, hls::Lack>, std::uint64_t> waits;
  std::map<std::size_t, std::uint64_t> all;
  std::map<std::size_t, Fill> fills;
};

TEST(Clocks, AWatchIsToldWhatUnitsWaitFor) {
  Add add;
  Pair pair;
  hls::Join join({{"add", {.stages = 3, .room = 2}}, {"pair", {.stages = 1, .room = 12}}});
  join.unit("add", "add", add);
  join.unit("pair", "pair", pair);
  join.constant(add.value, Byte(1));
  auto in = join.input("in", add.in);
  auto late = join.input("late", pair.in[0]);
  join.channel<Byte>("sums", hls::Writers(&add.out, hls::WriterFifo::kShort), {&pair.in[1]}, 12);
  auto out = join.output("out", pair.out);
  const std::vector<hls::FifoRecord> fifos = join.fifos();
  ASSERT_EQ(fifos.size(), 4u);
  EXPECT_EQ(fifos[0].channel, "in");
  EXPECT_EQ(fifos[0].depth, 0u);
  EXPECT_EQ(fifos[2].channel, "sums");
  EXPECT_EQ(fifos[2].port, "add.out");
  EXPECT_EQ(fifos[2].depth, 4u);  // two, and room for what two stages hold
  Notes notes;
  join.watch_clocks(notes);
  for (unsigned i = 0; i < 8; ++i) {
    in->push(Byte::from(i));
    join.arrives("in", 5);
    late->push(Byte(0));
    join.arrives("late", 20);
  }
  join.run_clocks();
  using hls::Lack;
  const std::uint64_t clocks = join.counters().at("pair.transactions") + notes.all[1];
  EXPECT_EQ(join.counters().at("add.transactions") + notes.all[0], clocks);
  EXPECT_EQ((notes.waits[{0, 0, Lack::kToken}]), 9u);  // five before its tokens, four behind them
  EXPECT_EQ((notes.waits[{1, 1, Lack::kToken}]), 20u);
  // Before clock 20 it sends two to the buffer before `pair` and four to the FIFO.
  EXPECT_EQ((notes.waits[{0, 2, Lack::kRoom}]), join.counters().at("add.stalls"));
  EXPECT_GT(join.counters().at("add.stalls"), 0u);
  EXPECT_EQ(notes.fills[2].tokens, 8u);
  EXPECT_GT(notes.fills[2].clocks, 4u * 10);
}

TEST(Clocks, AWatchChangesNothing) {
  const auto run = [](bool watched) {
    Send send;
    Receive receive;
    hls::Join join({{"send", {.stages = 2, .room = 2}}, {"receive", {.stages = 3, .room = 4}}});
    join.unit("send", "send", send);
    join.unit("receive", "receive", receive);
    auto in = join.input("in", send.in);
    join.repeat("job", hls::Writers{&send.out}, receive.in);
    auto out = join.output("out", receive.out);
    Notes notes;
    if (watched) join.watch_clocks(notes);
    for (unsigned i = 0; i < 8; ++i) {
      in->push(Job{uint<4>::from(i % 3), uint<6>::from(i)});
      join.arrives("in", 2 * i);
    }
    join.run_clocks();
    return std::pair(join.counters(), join.first_of("out"));
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(Clocks, ARowThatIsReadInTheClockThatWritesItIsTorn) {
  WriteTorn write;
  LookTorn look;
  hls::Join join({{"write", {.stages = 2, .room = 4, .ram_stages = {{"row", 1}}}},
                  {"look", {.stages = 1, .room = 4, .ram_stages = {{"row", 0}}}}});
  join.unit("write", "write", write);
  join.unit("look", "look", look);
  auto to_write = join.input("to_write", write.in);
  auto to_look = join.input("to_look", look.in);
  auto out = join.output("out", look.out);
  join.ram<hls::Hazard::kTorn>("rows", write.row, std::array{&look.row});
  to_write->push(Byte(7));
  join.arrives("to_write", 4);  // the row is written in clock 5
  for (const unsigned clock : {4, 5, 6}) {
    to_look->push(Byte(7));
    join.arrives("to_look", clock);
  }
  join.run_clocks();
  const List rows = values(*out);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], 0u) << "as it was";
  EXPECT_EQ(rows[1] & 1, 1u) << "torn";
  EXPECT_EQ(rows[2], 2u * 0xf8) << "as it is written, and no longer torn";
}

TEST(Clocks, AUnitMayTearWhatItReadsItself) {
  CountTorn count;
  hls::Join join(
      {{"count", {.stages = 4, .room = 8, .ram_stages = {{"before", 0}, {"after", 3}}}}});
  join.unit("count", "count", count);
  auto in = join.input("in", count.in);
  auto out = join.output("out", count.out);
  join.ram<hls::Hazard::kTorn>("rows", count.after, std::array{&count.before});
  for (const unsigned clock : {0, 1, 3, 4, 7, 8}) {
    in->push(Byte(7));
    join.arrives("in", clock);
  }
  join.run_clocks();
  // Each is written three clocks after it was read.
  const List rows = values(*out);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0], 0u);
  EXPECT_EQ(rows[1], 0u) << "the first is not written yet";
  EXPECT_EQ(rows[2] & 1, 1u) << "the first is being written";
  EXPECT_EQ(rows[3] & 1, 1u) << "and the second";
  EXPECT_EQ(rows[4] & 1, 1u) << "the fourth";
  EXPECT_EQ(rows[5], 2u * 2) << "as the fourth wrote it, who knew of the first alone";
}

TEST(Clocks, AUnitMustNotTearARowAsItReadsIt) {
  CountTorn count;
  hls::Join join(
      {{"count", {.stages = 1, .room = 4, .ram_stages = {{"before", 0}, {"after", 0}}}}});
  join.unit("count", "count", count);
  try {
    join.ram<hls::Hazard::kTorn>("rows", count.after, std::array{&count.before});
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "unit 'count' writes 'after' in stage 0, in which it reads it too; it would tear "
                 "its own row, which is not counted");
  }
}

TEST(Clocks, AfterTheLastOf32InputsComesTheFirst) {
  hls::Clocks clocks;
  clocks.unit("reader", {}, [] {});
  std::vector<unsigned> order, expected;
  std::vector<hls::Clocks::Feed> feeds;
  for (unsigned i = 0; i < 32; ++i) {
    hls::Clocks::Queue* queue = clocks.input();
    queue->push(0);
    queue->push(1);
    feeds.push_back({queue, [&order, i] {
                       order.push_back(i);
                       return true;
                     }});
  }
  clocks.feed("reader", {clocks.merge(feeds), [] { return true; }});
  clocks.run();
  for (unsigned i = 0; i < 64; ++i) expected.push_back(i % 32);
  EXPECT_EQ(order, expected);
}

TEST(Clocks, WantTheScheduleOfEveryModule) {
  Add add;
  hls::Join join(hls::ModuleSchedules{{"mul", {}}});
  try {
    join.unit("first", "add", add);
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "there is no schedule of module 'add'");
  }
}

}  // namespace
