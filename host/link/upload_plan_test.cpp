// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/upload_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace dynrt::host {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Parts = std::vector<MemoryBytes>;

TEST(UploadPlan, SendsEverythingAtFirstAndNothingTwice) {
  UploadPlan plan;
  const Parts image = {{100, {1, 2, 3, 4}}, {300, {0, 0}}, {8190, Bytes(100, 7)}};
  EXPECT_EQ(plan.changes(image), image);
  EXPECT_EQ(plan.changes(image), Parts{});
  plan.forget();
  EXPECT_EQ(plan.changes(image), image);
}

TEST(UploadPlan, SendsTheHalvesThatDiffer) {
  UploadPlan plan;
  Bytes bytes(200, 1);
  plan.changes(Parts{{0, bytes}});
  bytes[101] = 2;
  EXPECT_EQ(plan.changes(Parts{{0, bytes}}), (Parts{{100, {1, 2}}}));
}

TEST(UploadPlan, TakesAShortGapAlongAndNoLongOne) {
  for (const unsigned gap : {kFrameOverhead, kFrameOverhead + 2}) {
    UploadPlan plan;
    Bytes bytes(200, 1);
    plan.changes(Parts{{0, bytes}});
    bytes[10] = 2;
    bytes[12 + gap] = 3;
    EXPECT_EQ(plan.changes(Parts{{0, bytes}}).size(), gap == kFrameOverhead ? 1u : 2u) << gap;
  }
}

TEST(UploadPlan, SendsNoByteThatItDoesNotKnow) {
  UploadPlan plan;
  const Parts image = {{0, {1, 2}}, {4, {3, 4}}};
  EXPECT_EQ(plan.changes(image), image);
}

/// Random images one after another: what is sent makes the board's memory the image.
TEST(UploadPlan, MakesTheMemoryTheImage) {
  std::mt19937 random(1);
  UploadPlan plan;
  Bytes board(40'000);
  Bytes image(40'000);
  for (unsigned round = 0; round < 50; ++round) {
    Parts parts;
    for (unsigned i = 0; i < 20; ++i) {
      MemoryBytes part{static_cast<std::uint32_t>(2 * (random() % 19'000)),
                       Bytes(2 * (1 + random() % 200))};
      for (auto& byte : part.bytes) byte = static_cast<std::uint8_t>(random() % 2);
      std::ranges::copy(part.bytes, image.begin() + part.address);
      parts.push_back(std::move(part));
    }
    std::uint64_t carried = 0;
    for (const MemoryBytes& part : plan.changes(parts)) {
      ASSERT_EQ(part.address % 2, 0u);
      ASSERT_EQ(part.bytes.size() % 2, 0u);
      std::ranges::copy(part.bytes, board.begin() + part.address);
      carried += part.bytes.size();
    }
    ASSERT_EQ(board, image) << "round " << round;
    EXPECT_LT(carried, 20u * 400u);
  }
}

TEST(LineCost, CountsFramesAndTheLine) {
  const Parts parts = {{0, Bytes(1024, 1)}};
  const LineCost cost = upload_cost(parts);
  EXPECT_EQ(cost.frames, 2u);
  EXPECT_EQ(cost.carried, 1024u);
  EXPECT_GE(cost.sent, 1024u + 2 * kFrameOverhead);
  EXPECT_LE(cost.sent, 1024u + 2 * (kFrameOverhead + 6)) << "headers and CRC may have escapes";
  EXPECT_DOUBLE_EQ(cost.seconds, static_cast<double>(cost.sent) * 10 / 3e6);
  EXPECT_EQ(upload_cost(Parts{{0, Bytes(512, kLinkFlag)}}).sent,
            512 + upload_cost(Parts{{0, Bytes(512, 1)}}).sent)
      << "the worst bytes take twice the line";
}

TEST(LineCost, OfReadsIsThatOfTheirAnswers) {
  const LineCost cost = read_cost(1000, 16);
  EXPECT_EQ(cost.frames, 4u) << "of 16 beats each";
  EXPECT_EQ(cost.carried, 1000u);
  EXPECT_EQ(cost.sent, 1000u + 4 * kAnswerOverhead);
  EXPECT_DOUBLE_EQ(cost.seconds, static_cast<double>(cost.sent) * 10 / 3e6);
  EXPECT_EQ(read_cost(512, 64).frames, 1u) << "a frame has 512 bytes at most";
}

}  // namespace
}  // namespace dynrt::host
