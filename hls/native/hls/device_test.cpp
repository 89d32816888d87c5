// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A device outside a join, between an output and an input.
#include "hls/device.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "hls/join_test_units.h"

namespace {

using hls::testing::Add;
using hls::testing::Byte;
using hls::testing::List;
using hls::testing::values;

using Writes = std::vector<std::pair<std::uint64_t, Byte>>;  ///< with their clocks

/// Answers a request after `delay` clocks, by as many tokens as its number says.
class Repeater final : public hls::Device {
 public:
  using Queue = std::shared_ptr<hls::Fifo<Byte>>;
  Repeater(Queue requests, Queue answers, Queue writes, std::uint64_t delay)
      : requests_(std::move(requests)),
        answers_(std::move(answers)),
        writes_(std::move(writes)),
        delay_(delay) {}

  void take(std::uint64_t now) override {
    taken_.push_back(now);
    due_.push_back({now + delay_ - 1, requests_->pop()});
  }
  std::size_t answer(std::uint64_t now) override {
    if (due_.empty() || due_.front().first > now) return 0;
    const Byte number = due_.front().second;
    due_.erase(due_.begin());
    const auto count = static_cast<std::size_t>(number.to_u64());
    for (std::size_t i = 0; i < count; ++i) answers_->push(number);
    return count;
  }
  void take_write(std::uint64_t now) override { written_.push_back({now, writes_->pop()}); }
  std::uint64_t next() const override { return due_.empty() ? hls::kNever : due_.front().first; }
  const std::vector<std::uint64_t>& taken() const { return taken_; }
  const Writes& written() const { return written_; }

 private:
  Queue requests_, answers_, writes_;
  std::uint64_t delay_;
  std::vector<std::pair<std::uint64_t, Byte>> due_;
  std::vector<std::uint64_t> taken_;
  Writes written_;
};

/// Two units with a device between them, and one that writes to it; each adds one.
struct Chain {
  Add before, after, writer;
  hls::Join join;
  std::shared_ptr<hls::Fifo<Byte>> in, out, written;
  std::unique_ptr<Repeater> device;

  Chain(hls::Join made, std::uint64_t delay) : join(std::move(made)) {
    join.unit("before", "add", before);
    join.unit("after", "add", after);
    join.unit("writer", "add", writer);
    join.config("one", std::make_shared<Byte>(Byte(1)),
                std::vector{&before.value, &after.value, &writer.value});
    in = join.input("in", before.in);
    out = join.output("out", after.out);
    auto requests = join.output("requests", before.out);
    auto answers = join.input("answers", after.in);
    written = join.input("written", writer.in);
    auto writes = join.output("writes", writer.out);
    device = std::make_unique<Repeater>(requests, answers, writes, delay);
    join.attach("requests", "answers", *device, "writes");
  }
};

TEST(Device, AnswersWithoutClocks) {
  Chain chain(hls::Join(), 5);
  chain.in->push(Byte(1));
  chain.in->push(Byte(2));
  chain.join.run();
  EXPECT_EQ(values(*chain.out), (List{3, 3, 4, 4, 4}));
}

TEST(Device, AnswersInItsOwnTime) {
  Chain chain(hls::Join({{"add", {.stages = 3, .room = 6}}}), 50);
  chain.in->push(Byte(2));
  chain.join.arrives("in", 4);
  chain.in->push(Byte(0));
  chain.join.arrives("in", 5);
  chain.join.run_clocks();
  EXPECT_EQ(chain.device->taken(), (std::vector<std::uint64_t>{4 + 3, 5 + 3}));
  // Three answers in three clocks from clock 57 on, while the other's one comes in clock 58 and
  // waits behind the first.
  EXPECT_EQ(chain.join.first_of("out"), 4u + 3 + 50 + 3);
  EXPECT_EQ(values(*chain.out), (List{4, 4, 4, 2}));
}

TEST(Device, TakesWritesWithoutClocks) {
  Chain chain(hls::Join(), 5);
  chain.written->push(Byte(7));
  chain.join.run();
  EXPECT_EQ(chain.device->written(), (Writes{{0, Byte(8)}}));
}

TEST(Device, TakesWritesInTheClocksThatTheyComeIn) {
  Chain chain(hls::Join({{"add", {.stages = 3, .room = 6}}}), 50);
  chain.written->push(Byte(7));
  chain.join.arrives("written", 4);
  chain.in->push(Byte(0));
  chain.join.arrives("in", 4);
  chain.written->push(Byte(9));
  chain.join.arrives("written", 90);
  chain.join.run_clocks();
  EXPECT_EQ(chain.device->taken(), (std::vector<std::uint64_t>{4 + 3}));
  EXPECT_EQ(chain.device->written(), (Writes{{4 + 3, Byte(8)}, {90 + 3, Byte(10)}}));
}

}  // namespace
