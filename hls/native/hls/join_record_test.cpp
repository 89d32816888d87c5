// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a join records of its units, channels, counters and values.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hls/join_test_units.h"

namespace {

using hls::uint;
using hls::testing::Add;
using hls::testing::Byte;
using hls::testing::Pair;

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
    independent[counter.name()] = counter.order_independent;
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
  EXPECT_TRUE(Viewer::hls_file().ends_with("native/hls/join_record_test.cpp"))
      << Viewer::hls_file();
}

}  // namespace
