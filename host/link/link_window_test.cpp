// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/link_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace dynrt::host {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr bool kReads = false;
constexpr bool kWrites = true;

std::vector<std::size_t> sent(LinkWindow& window) {
  std::vector<std::size_t> requests;
  while (const auto next = window.next()) requests.push_back(*next);
  return requests;
}
void answer(LinkWindow& window, std::size_t request) {
  ASSERT_EQ(window.under_way(static_cast<std::uint8_t>(request)), request);
  window.answer(request);
}

TEST(LinkWindow, HasSoManyUnderWay) {
  LinkWindow window(5, 3, kReads);
  EXPECT_THAT(sent(window), ElementsAre(0, 1, 2));
  answer(window, 0);
  EXPECT_THAT(sent(window), ElementsAre(3));
  answer(window, 1);
  answer(window, 2);
  EXPECT_THAT(sent(window), ElementsAre(4));
  answer(window, 3);
  EXPECT_FALSE(window.done());
  answer(window, 4);
  EXPECT_TRUE(window.done());
  EXPECT_EQ(window.repeats(), 0u);
}

TEST(LinkWindow, NumbersBeginAnew) {
  LinkWindow window(1000, 32, kReads);
  for (std::size_t i = 0; i < 1000; ++i) {
    sent(window);
    answer(window, i);
  }
  EXPECT_TRUE(window.done());
}

TEST(LinkWindow, AsksAloneForALostAnswerOfARead) {
  LinkWindow window(6, 4, kReads);
  sent(window);
  answer(window, 2);
  EXPECT_THAT(sent(window), ElementsAre(0, 1)) << "which were sent before";
  answer(window, 3);
  EXPECT_THAT(sent(window), IsEmpty()) << "0 and 1 were sent after 3";
  answer(window, 0);
  answer(window, 1);
  EXPECT_THAT(sent(window), ElementsAre(4, 5));
  EXPECT_EQ(window.repeats(), 2u);
}

TEST(LinkWindow, TheAnswerToAWriteTellsOfThoseBefore) {
  LinkWindow window(4, 4, kWrites);
  sent(window);
  answer(window, 2);
  EXPECT_EQ(window.answered(), 3u);
  answer(window, 3);
  EXPECT_TRUE(window.done());
  EXPECT_EQ(window.repeats(), 0u);
}

TEST(LinkWindow, GoesBackToAMissingWriteOnce) {
  LinkWindow window(8, 6, kWrites);
  sent(window);
  window.missing(2);  // says the board to frame 3, and to 4 and 5
  EXPECT_EQ(window.answered(), 2u);
  EXPECT_THAT(sent(window), ElementsAre(2, 3, 4, 5, 6, 7));
  window.missing(2);
  window.missing(2);
  EXPECT_THAT(sent(window), IsEmpty());
  for (std::size_t i = 2; i < 8; ++i) answer(window, i);
  EXPECT_TRUE(window.done());
  EXPECT_EQ(window.repeats(), 4u);
}

TEST(LinkWindow, GoesBackAgainIfTheRepeatedWriteIsMissing) {
  LinkWindow window(3, 3, kWrites);
  sent(window);
  window.missing(0);
  sent(window);
  window.missing(0);
  window.missing(0);
  EXPECT_THAT(sent(window), IsEmpty()) << "1 and 2 as they were sent first";
  window.missing(0);
  EXPECT_THAT(sent(window), ElementsAre(0, 1, 2));
}

TEST(LinkWindow, AMissingReadTellsThatEarlierAnswersAreLost) {
  LinkWindow window(4, 4, kReads);
  sent(window);
  answer(window, 0);
  window.missing(2);
  EXPECT_THAT(sent(window), ElementsAre(1, 2, 3));
}

TEST(LinkWindow, IgnoresNumbersThatAreNotUnderWay) {
  LinkWindow window(10, 2, kReads);
  EXPECT_EQ(window.under_way(0), std::nullopt);
  window.missing(7);
  sent(window);
  EXPECT_EQ(window.under_way(2), std::nullopt);
  EXPECT_EQ(window.under_way(255), std::nullopt);
  window.missing(200);
  EXPECT_THAT(sent(window), IsEmpty());
  answer(window, 1);
  EXPECT_EQ(window.under_way(1), std::nullopt) << "it is answered";
}

TEST(LinkWindow, RepeatsEverythingThatIsNotAnswered) {
  LinkWindow window(4, 3, kReads);
  sent(window);
  answer(window, 0);
  sent(window);
  window.repeat_all();
  EXPECT_THAT(sent(window), ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace dynrt::host
