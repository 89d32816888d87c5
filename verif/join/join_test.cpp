// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The Verilog top that comes from a join: its text, and that it does what the native join does.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdlib>
#include <deque>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "Vring.h"
#include "hls/bits.h"
#include "hls/random.h"
#include "join/emit_top.h"
#include "join/ring_join.h"

namespace dynrt::ring {
namespace {

using hls::testing::Random;

/// DYNRT_UPDATE_GOLDENS=1 writes the file anew.
void expect_golden(const std::string& name, const std::string& text) {
  const std::string path = std::string(GOLDEN_FOLDER "/") + name;
  if (std::getenv("DYNRT_UPDATE_GOLDENS")) std::ofstream(path) << text;
  std::stringstream golden;
  golden << std::ifstream(path).rdbuf();
  EXPECT_EQ(text, golden.str()) << path << " is not what the join gives; if that is meant, run the "
                                << "test with DYNRT_UPDATE_GOLDENS=1";
}

TEST(Top, IsTheGoldenOne) {
  const Ring ring;
  expect_golden("ring.v", hlsc::emit_top(ring.join.record(), "ring"));
  expect_golden("ring.json", hlsc::emit_json(ring.join.record(), "ring"));
  expect_golden("ring.dot", hlsc::emit_diagram(ring.join.record()));
}

std::string refusal(const hls::Join& join) {
  try {
    hlsc::emit_top(join.record(), "top");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Top, NamesThePortThatNothingIsConnectedTo) {
  Side side;
  hls::Join join;
  join.unit("left", "side", side);
  join.input("item", side.item);
  join.output("out", side.out);
  join.constant(side.add, uint<8>(1));
  EXPECT_EQ(refusal(join),
            "port 'odd' of unit 'left' is not connected; join it to a channel, a RAM or a value");
}

TEST(Top, NamesTheForkThatNeedsABound) {
  Number number;
  Pair pair;
  hls::Join join;
  join.unit("number", "number", number);
  join.unit("pair", "pair", pair);
  join.input("job", number.job);
  join.bank("salt", number.bank, std::make_shared<std::vector<uint<32>>>(kItems));
  for (auto* note : {&number.note, &pair.note}) {
    join.bank("note", *note, std::make_shared<std::vector<Value>>(16));
  }
  join.channel<Item>("item", {&number.item}, {&pair.side[0], &pair.side[1], &pair.before});
  join.output("out", pair.out);
  EXPECT_EQ(refusal(join),
            "channel 'item' forks to 'pair.side_0', which waits for other tokens too; say how many "
            "tokens the channel can hold");
}

/// A chain of 85 units, whose 84 channels count once and whose units twice, with `sinks` channels
/// more.
struct Chain {
  std::vector<Side> units{85};
  hls::Join join;

  explicit Chain(std::size_t sinks) {
    for (std::size_t i = 0; i < units.size(); ++i) {
      const std::string number = std::to_string(i);
      join.unit("side_" + number, "side", units[i]);
      join.constant(units[i].add, uint<8>(1));
      if (i == 0) join.input("item", units[i].item);
      if (i > 0) join.channel("item_" + number, units[i - 1].out, units[i].item);
      if (i < sinks) join.sink("odd_" + number, units[i].odd);
      if (i >= sinks) join.output("odd_" + number, units[i].odd);
    }
    join.output("out", units.back().out);
  }
};

TEST(Top, CountsNoMoreThanItsCountersHold) {
  const Chain most(2);
  EXPECT_EQ(hlsc::counter_names(most.join.record()).size(), 256u);
  EXPECT_EQ(refusal(most.join), "none");
  EXPECT_EQ(refusal(Chain(3).join),
            "the join has 257 counters, one for every channel inside and two for every unit; a top "
            "counts at most 256: join fewer units, or widen the address of hls_counters");
}

/// The native join's items of one job, by index.
std::map<std::uint64_t, Item> items_of(Ring& ring, const Job& job, bool second) {
  ring.job[second]->push(job);
  ring.join.run();
  std::map<std::uint64_t, Item> items;
  while (!ring.done->empty()) {
    const Item item = ring.done->pop();
    EXPECT_EQ(item.id, job.id);
    EXPECT_TRUE(items.emplace(item.index.to_u64(), item).second);
  }
  EXPECT_EQ(items.size(), job.repeat.to_u64() + 1);
  return items;
}

/// The Verilated top with what surrounds it. An id is given to a new job when all items of the one
/// before have come.
class Outside {
 public:
  explicit Outside(std::uint64_t seed) : random_(seed) {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed) + 1);
    for (auto& word : *ring_.salt) word = uint<32>::from(random_.next());
    *ring_.add = uint<8>::from(random_.next());
    top_.add_i = static_cast<std::uint8_t>(ring_.add->to_u64());
    top_.counter_clear_i = 0;
    top_.rst_ni = 0;
    for (unsigned i = 0; i < 16; ++i) clock();
    top_.rst_ni = 1;
  }

  void run(unsigned jobs, bool stalls) {
    unsigned idle = 0;
    for (unsigned number = 0; finished_ < jobs; ++number) {
      if (stalls && number % 200 == 0) {
        for (double& stall : stall_) stall = random_.below(2) == 0 ? 0 : 0.7;
      }
      for (unsigned side = 0; side < 2; ++side) {
        if (!offered_[side] && begun_ < jobs && !random_.chance(stall_[side])) offer(side);
      }
      top_.done_ready_i = !random_.chance(stall_[2]);
      const unsigned before = begun_ + finished_ + items_;
      clock();
      if (testing::Test::HasFatalFailure()) return;
      idle = before == begun_ + finished_ + items_ ? idle + 1 : 0;
      ASSERT_LT(idle, 5000u) << "nothing moves any more";
    }
  }
  std::uint32_t counter(unsigned address) {
    top_.counter_addr_i = static_cast<std::uint8_t>(address);
    clock();
    clock();
    return top_.counter_data_o;
  }
  const Ring& ring() const { return ring_; }
  unsigned items() const { return items_; }

 private:
  /// Makes a job with an id that is free, if there is one.
  void offer(unsigned side) {
    const std::uint64_t id = random_.below(16);
    if (expected_[id]) return;
    Job job{uint<3>::from(random_.next()), Id::from(id), Value::from(random_.next())};
    expected_[id] = items_of(ring_, job, side == 1);
    offered_[side] = job;
    ++begun_;
  }
  void clock() {
    top_.clk_i = 0;
    top_.job_0_valid_i = offered_[0].has_value();
    top_.job_1_valid_i = offered_[1].has_value();
    if (offered_[0]) top_.job_0_data_i = hls::pack(*offered_[0])[0];
    if (offered_[1]) top_.job_1_data_i = hls::pack(*offered_[1])[0];
    top_.salt_data_i = static_cast<std::uint32_t>(random_.next());
    if (salt_.front()) top_.salt_data_i = static_cast<std::uint32_t>(*salt_.front());
    top_.eval();
    const bool reset = top_.rst_ni == 0;
    const bool taken[2] = {!reset && top_.job_0_ready_o != 0, !reset && top_.job_1_ready_o != 0};
    for (unsigned side = 0; side < 2; ++side) {
      if (taken[side]) offered_[side].reset();
    }
    if (!reset && top_.done_valid_o && top_.done_ready_i)
      take(hls::unpack<Item>(&top_.done_data_o));
    if (!reset && top_.result_en_o) result_[top_.result_addr_o] = top_.result_data_o;
    salt_.pop_front();
    salt_.push_back(std::nullopt);
    if (top_.salt_en_o && !reset) salt_.back() = (*ring_.salt)[top_.salt_addr_o].to_u64();
    top_.clk_i = 1;
    top_.eval();
  }
  void take(const Item& item) {
    ++items_;
    auto& expected = expected_[item.id.to_u64()];
    ASSERT_TRUE(expected) << "no job has this id: " << hls::describe(item);
    const auto found = expected->find(item.index.to_u64());
    ASSERT_NE(found, expected->end()) << "an item comes twice: " << hls::describe(item);
    const auto difference = hls::first_difference(item, found->second);
    ASSERT_FALSE(difference) << difference->text();
    const ItemRow row = item_row(item);
    ASSERT_EQ(result_[static_cast<unsigned>(row.to_u64())], item.value.to_u64())
        << "the row comes before the token";
    expected->erase(found);
    if (!expected->empty()) return;
    expected.reset();
    ++finished_;
  }

  VerilatedContext context_;
  Vring top_{&context_};
  Ring ring_;
  Random random_;
  double stall_[3] = {};
  std::optional<Job> offered_[2];
  std::optional<std::map<std::uint64_t, Item>> expected_[16];
  std::deque<std::optional<std::uint64_t>> salt_ = std::deque<std::optional<std::uint64_t>>(3);
  std::map<unsigned, std::uint64_t> result_;
  unsigned begun_ = 0, finished_ = 0, items_ = 0;
};

TEST(Top, DoesWhatTheNativeJoinDoes) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    fmt::print("seed {}\n", seed);
    Outside outside(seed);
    outside.run(2000, seed != 1);
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_GT(outside.items(), 8000u);
    const auto native = outside.ring().join.counters();
    const auto names = hlsc::counter_names(outside.ring().join.record());
    unsigned compared = 0;
    for (unsigned i = 0; i < names.size(); ++i) {
      const auto found = native.find(names[i]);
      if (found == native.end()) continue;  // stalls are the RTL's own
      ++compared;
      EXPECT_EQ(outside.counter(i), found->second) << names[i];
    }
    EXPECT_EQ(compared, native.size());
  }
}

}  // namespace
}  // namespace dynrt::ring
