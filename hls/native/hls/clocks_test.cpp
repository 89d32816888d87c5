// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Clocks of a join whose units have schedules.
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "hls/join_test_units.h"

namespace {

using hls::uint;
using hls::testing::Add;
using hls::testing::Byte;
using hls::testing::Job;
using hls::testing::List;
using hls::testing::Receive;
using hls::testing::Send;
using hls::testing::values;

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

TEST(Clocks, AfterTheLastOf32InputsComesTheFirst) {
  hls::Clocks clocks;
  clocks.unit("reader", {}, [] {});
  std::vector<unsigned> order, expected;
  std::vector<hls::Clocks::Feed> feeds;
  for (unsigned i = 0; i < 32; ++i) {
    hls::Clocks::Queue* queue = clocks.input();
    queue->ready = {0, 1};
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
