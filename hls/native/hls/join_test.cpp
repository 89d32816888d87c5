// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// How tokens go from unit to unit: channels, forks, repeated jobs, RAMs.
#include "hls/join.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "hls/join_test_units.h"

namespace {

using hls::uint;
using hls::testing::Add;
using hls::testing::Byte;
using hls::testing::Job;
using hls::testing::List;
using hls::testing::Look;
using hls::testing::LookAtWord;
using hls::testing::NumberedJob;
using hls::testing::Pair;
using hls::testing::Receive;
using hls::testing::Send;
using hls::testing::values;
using hls::testing::Write;
using hls::testing::WriteWords;

TEST(Join, SeveralWritersMeetInOneChannel) {
  Add a, b, sum;
  hls::Join join;
  join.unit("a", "add", a);
  join.unit("b", "add", b);
  join.unit("sum", "add", sum);
  const auto in_a = join.input("in_a", a.in);
  const auto in_b = join.input("in_b", b.in);
  join.constant(a.value, Byte(10));
  join.constant(b.value, Byte(20));
  join.constant(sum.value, Byte(100));
  join.channel<Byte>("merged", {&a.out, &b.out}, {&sum.in});
  const auto out = join.output("out", sum.out);
  for (unsigned i = 0; i < 3; ++i) {
    in_a->push(Byte::from(i));
    in_b->push(Byte::from(i));
  }
  join.run();
  List got = values(*out);
  std::sort(got.begin(), got.end());
  EXPECT_EQ(got, (List{110, 111, 112, 120, 121, 122})) << "each token once, in some order";
  EXPECT_EQ(join.counters().at("merged.tokens"), 6u);
  EXPECT_EQ(join.counters().at("sum.transactions"), 6u);
}

TEST(Join, AWatcherSeesEveryTransactionBeforeItIsMade) {
  Add first, second;
  hls::Join join;
  join.unit("first", "add", first);
  join.unit("second", "add", second);
  const auto in = join.input("in", first.in);
  join.constant(first.value, Byte(10));
  join.constant(second.value, Byte(1));
  join.channel<Byte>("between", {&first.out}, {&second.in});
  const auto out = join.output("out", second.out);
  std::vector<List> seen(2);
  join.watch([&](std::size_t unit, std::uint64_t clock) {
    EXPECT_EQ(clock, 0u);
    const Add& of = unit == 0 ? first : second;
    seen[unit].push_back(of.in.queue()->front().to_u64());
  });
  for (unsigned i = 0; i < 3; ++i) in->push(Byte::from(i));
  join.run();
  EXPECT_EQ(seen[0], (List{0, 1, 2}));
  EXPECT_EQ(seen[1], (List{10, 11, 12}));
  EXPECT_EQ(values(*out), (List{11, 12, 13}));
  join.watch({});
  in->push(Byte(7));
  join.run();
  EXPECT_EQ(seen[0].size(), 3u);
}

TEST(Join, WhatAWatcherThrowsEndsTheRun) {
  Add add;
  hls::Join join;
  join.unit("add", "add", add);
  const auto in = join.input("in", add.in);
  join.constant(add.value, Byte(10));
  const auto out = join.output("out", add.out);
  join.watch([](std::size_t, std::uint64_t) { throw std::runtime_error("enough"); });
  in->push(Byte(1));
  EXPECT_THROW(join.run(), std::runtime_error);
  EXPECT_TRUE(out->empty());
}

TEST(Join, EveryReaderOfAForkSeesEveryToken) {
  Add first;
  Pair pair;
  hls::Join join;
  join.unit("first", "add", first);
  join.unit("pair", "pair", pair);
  const auto in = join.input("in", first.in);
  const auto value = std::make_shared<Byte>(Byte(1));
  join.config<Byte>("value", value, {&first.value});
  join.channel<Byte>("both", {&first.out}, {&pair.in[0], &pair.in[1]}, 4);
  const auto out = join.output("out", pair.out);
  for (unsigned i = 0; i < 40; ++i) in->push(Byte::from(i));
  join.run();
  List expected;
  for (unsigned i = 1; i <= 40; ++i) expected.push_back(i * 257);
  EXPECT_EQ(values(*out), expected);
  EXPECT_EQ(join.counters().at("both.tokens"), 40u) << "a forked token is one token";
  *value = 5;
  in->push(Byte(0));
  join.run();
  EXPECT_EQ(values(*out), List{5 * 257});
}

TEST(Join, AUnitWaitsForAllItsInputs) {
  Pair pair;
  hls::Join join;
  join.unit("pair", "pair", pair);
  const auto left = join.input("left", pair.in[0]);
  const auto right = join.input("right", pair.in[1]);
  const auto out = join.output("out", pair.out);
  left->push(Byte(1));
  left->push(Byte(2));
  join.run();
  EXPECT_TRUE(out->empty());
  right->push(Byte(0));
  join.run();
  EXPECT_EQ(values(*out), List{1});
  EXPECT_EQ(join.counters().at("pair.transactions"), 1u);
}

TEST(Join, ARepeatedJobIsNumberedAndItsLastOneSaysSo) {
  Send a, b;
  Receive receive;
  hls::Join join;
  join.unit("a", "send", a);
  join.unit("b", "send", b);
  join.unit("receive", "receive", receive);
  const auto in_a = join.input("in_a", a.in);
  const auto in_b = join.input("in_b", b.in);
  join.repeat("jobs", hls::Writers{&a.out, &b.out}, receive.in);
  const auto out = join.output("out", receive.out);
  in_a->push(Job{2, 11});
  in_a->push(Job{0, 12});
  in_b->push(Job{15, 13});
  join.run();
  EXPECT_EQ(join.counters().at("jobs.tokens"), 3u) << "counted before they are repeated";
  std::vector<unsigned> seen(64);
  while (!out->empty()) {
    const auto name = static_cast<std::size_t>(out->pop().job.name.to_u64());
    ++seen[name];
  }
  EXPECT_EQ(seen[11], 3u);
  EXPECT_EQ(seen[12], 1u);
  EXPECT_EQ(seen[13], 16u);
  in_a->push(Job{3, 14});
  join.run();
  for (unsigned i = 0; i < 4; ++i) {
    const NumberedJob job = out->pop();
    EXPECT_EQ(job.index, uint<4>::from(i));
    EXPECT_EQ(job.last, i == 3);
    EXPECT_EQ(job.job.name, uint<6>(14));
    EXPECT_EQ(job.job.repeat, uint<4>(3));
  }
}

TEST(Join, ARamHasOneWriterAndManyReaders) {
  Write write;
  Look left, right;
  hls::Join join;
  join.unit("write", "write", write);
  join.unit("left", "look", left);
  join.unit("right", "look", right);
  const auto in = join.input("in", write.in);
  const auto in_left = join.input("in_left", left.in);
  const auto in_right = join.input("in_right", right.in);
  join.ram("rows", write.row, std::array{&left.row, &right.row});
  const auto out_left = join.output("out_left", left.out);
  const auto out_right = join.output("out_right", right.out);
  in->push(Byte(3));
  join.run();
  for (const auto& queue : {in_left, in_right}) queue->push(Byte(3)), queue->push(Byte(4));
  join.run();
  EXPECT_EQ(values(*out_left), (List{252, 0}));
  EXPECT_EQ(values(*out_right), (List{252, 0}));
  EXPECT_EQ(join.record().rams.at(0).readers, (std::vector<std::string>{"left.row", "right.row"}));
}

TEST(Join, ARamOfWordsIsWrittenByRowsAndReadByWords) {
  WriteWords writer;
  LookAtWord reader;
  hls::Join join;
  join.unit("writer", "writer", writer);
  join.unit("reader", "reader", reader);
  auto rows = join.input("rows", writer.in);
  auto addresses = join.input("addresses", reader.in);
  auto words = join.output("words", reader.out);
  join.ram_of_words("table", writer.row, std::array{&reader.word});
  rows->push(5);
  rows->push(9);
  join.run();
  for (const unsigned address : {5u, 9u, 256u + 5, 512u + 5, 512u + 9}) {
    addresses->push(uint<10>::from(address));
  }
  join.run();
  EXPECT_EQ(values(*words), (List{5, 9, 250, 4, 8}));
  const hls::RamRecord& ram = join.record().rams.front();
  EXPECT_EQ(ram.width, 24u);
  EXPECT_EQ(ram.rows, 256u);
  EXPECT_EQ(ram.words, 3u);
}

TEST(Join, ASinkCountsAndDrops) {
  Add add;
  hls::Join join;
  join.unit("add", "add", add);
  const auto in = join.input("in", add.in);
  join.constant(add.value, Byte(0));
  join.sink("dropped", add.out);
  for (unsigned i = 0; i < 7; ++i) in->push(Byte(0));
  join.run();
  EXPECT_EQ(join.counters().at("dropped.tokens"), 7u);
}

TEST(Join, APortOfAStrangerIsAnError) {
  Add known, stranger;
  hls::Join join;
  join.unit("known", "add", known);
  try {
    join.channel("sums", stranger.out, known.in);
    FAIL() << "nothing was thrown";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(),
                 "the join connects a port whose unit it does not have, or which the unit does not "
                 "name in HLS_PORTS");
  }
}

}  // namespace
