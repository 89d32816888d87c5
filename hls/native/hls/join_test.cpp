// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/join.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace {

using hls::uint;
using Byte = uint<8>;

/// Adds its value to every token.
struct Add {
  hls::In<Byte> in;
  hls::Config<Byte> value;
  hls::Out<Byte> out;
  HLS_PORTS(in, value, out)
  void step() { out.write((in.read() + value.get()).trunc<8>()); }
};
/// Needs a token from both sides.
struct Pair {
  hls::In<Byte> in[2];
  hls::Out<uint<16>> out;
  HLS_PORTS(in[0], in[1], out)
  void step() {
    const Byte low = in[0].read();
    out.write(hls::concat(in[1].read(), low));
  }
};
struct Write {
  hls::In<Byte> in;
  hls::RamWrite<Byte, 256> row;
  HLS_PORTS(in, row)
  void step() {
    const Byte b = in.read();
    row.write(b, ~b);
  }
};
struct Look {
  hls::In<Byte> in;
  hls::RamRead<Byte, 256> row;
  hls::Out<Byte> out;
  HLS_PORTS(in, row, out)
  void step() { out.write(row.read(in.read())); }
};
struct WriteWords {
  hls::In<Byte> in;
  hls::RamWrite<std::array<Byte, 3>, 256> row;
  HLS_PORTS(in, row)
  void step() {
    const Byte b = in.read();
    row.write(b, {b, ~b, b ^ Byte(1)});
  }
};
struct LookAtWord {
  hls::In<uint<10>> in;
  hls::RamRead<Byte, 768> word;
  hls::Out<Byte> out;
  HLS_PORTS(in, word, out)
  void step() { out.write(word.read(in.read())); }
};
struct Job {
  uint<4> repeat;
  uint<6> name;
  HLS_FIELDS(repeat, name)
};
struct NumberedJob {
  uint<4> index;
  bool last = false;
  Job job;
  HLS_FIELDS(index, last, job)
};
struct Send {
  hls::In<Job> in;
  hls::Out<Job> out;
  HLS_PORTS(in, out)
  void step() { out.write(in.read()); }
};
struct Receive {
  hls::In<NumberedJob> in;
  hls::Out<NumberedJob> out;
  HLS_PORTS(in, out)
  void step() { out.write(in.read()); }
};

template <class T>
std::vector<std::uint64_t> values(hls::Fifo<T>& queue) {
  std::vector<std::uint64_t> list;
  while (!queue.empty()) list.push_back(queue.pop().to_u64());
  return list;
}
using List = std::vector<std::uint64_t>;

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
  join.repeat("jobs", std::vector{&a.out, &b.out}, receive.in);
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
  join.ram("rows", write.row, std::vector{&left.row, &right.row});
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
  join.ram_of_words("table", writer.row, std::vector{&reader.word});
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

TEST(Join, RecordsWhatItConnected) {
  Add add;
  Pair pair;
  hls::Join join;
  join.unit("add", "add", add);
  join.unit("pair", "pair", pair);
  join.input("left", pair.in[0]);
  join.constant(add.value, Byte(9));
  join.channel("sums", add.out, pair.in[1], 12);
  const hls::JoinRecord& record = join.record();
  ASSERT_EQ(record.units.size(), 2u);
  EXPECT_EQ(record.units[1].module, "pair");
  ASSERT_EQ(record.units[1].ports.size(), 3u);
  EXPECT_EQ(record.units[1].ports[1].name, "in_1") << "a port of an array, as hlsc names it";
  EXPECT_EQ(record.units[1].ports[2].type.kind, hls::PortKind::kOut);
  EXPECT_EQ(record.units[1].ports[2].type.width, 16u);
  ASSERT_EQ(record.channels.size(), 2u);
  EXPECT_EQ(record.channels[1].from, std::vector<std::string>{"add.out"});
  EXPECT_EQ(record.channels[1].to, std::vector<std::string>{"pair.in_1"});
  EXPECT_EQ(record.channels[1].depth, 12u);
  ASSERT_EQ(record.configs.size(), 1u);
  EXPECT_TRUE(record.configs[0].constant);
  EXPECT_EQ(record.configs[0].value, 9u);
}

TEST(Join, SaysWhichCountersDependOnTheOrder) {
  Add add;
  Pair pair;
  hls::Join join;
  join.unit("add", "add", add);
  join.unit("pair", "pair", pair);
  join.input("left", pair.in[0]);
  join.channel("sums", add.out, pair.in[1]);
  join.depends_on_order({"sums", "pair"});
  std::map<std::string, bool> independent;
  for (const auto& counter : hls::counters_of(join.record())) {
    independent[counter.name] = counter.order_independent;
  }
  const std::map<std::string, bool> expected = {
      {"sums.tokens", false}, {"add.transactions", true}, {"pair.transactions", false},
      {"add.stalls", false},  {"pair.stalls", false},
  };
  EXPECT_EQ(independent, expected);
  EXPECT_THROW(join.depends_on_order({"sum"}), std::logic_error);
}

struct View {
  Byte near;
  std::array<uint<3>, 2> pair;
  uint<1> flag;
  HLS_FIELDS(near, pair, flag)
};
struct Viewer {
  hls::In<Byte> in;
  hls::Config<View> view;
  HLS_PORTS(in, view)
  void step() { in.read(); }
};

TEST(Join, RecordsTheFieldsOfAValue) {
  Viewer viewer;
  hls::Join join;
  join.unit("viewer", "viewer", viewer);
  join.config<View>("view", std::make_shared<View>(), {&viewer.view});
  const hls::ConfigRecord& view = join.record().configs.at(0);
  EXPECT_EQ(view.width, 15u);
  ASSERT_EQ(view.fields.size(), 3u);
  EXPECT_EQ(view.fields[0].name, "near");
  EXPECT_EQ(view.fields[1].name, "pair");
  EXPECT_EQ(view.fields[1].offset, 8u);
  EXPECT_EQ(view.fields[1].width, 6u);
  EXPECT_EQ(view.fields[2].offset, 14u);
}

TEST(Join, KnowsAUnitsTypeAndFile) {
  EXPECT_EQ(hls::type_name<Viewer>(), "(anonymous namespace)::Viewer");
  EXPECT_EQ(hls::type_name<std::vector<uint<3>>>(), "std::vector<hls::uint<3>>");
  EXPECT_TRUE(Viewer::hls_file().ends_with("native/hls/join_test.cpp")) << Viewer::hls_file();
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
  // The first comes to `last` in clock 9, as one from the left does, which comes before the right
  // in the list but after it where the left had sent last.
  for (const unsigned clock : {0, 6, 6}) {
    to_left->push(Byte(10));
    join.arrives("to_left", clock);
  }
  to_right->push(Byte(20));
  join.arrives("to_right", 2);
  join.run_clocks();
  EXPECT_EQ(values(*out), (List{12, 22, 12, 12}));
  EXPECT_EQ(join.first_of("out"), 0u + 3 + 3);
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
  join.repeat("job", std::vector{&send.out}, receive.in);
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
