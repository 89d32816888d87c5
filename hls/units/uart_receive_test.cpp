// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/uart_receive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "units/test_bench.h"
#include "units/uart_send.h"

namespace dynrt {
namespace {

class UartReceiveTest : public testing::Test {
 protected:
  void set(unsigned divisor) {
    bench_.value(bench_.unit.divisor) = LineDivisor::from(divisor);
    hold(true, 20);
  }
  void hold(bool high, unsigned clocks) {
    for (unsigned i = 0; i < clocks; ++i) bench_.feed(bench_.unit.sample, uint<1>(high));
  }
  /// A byte whose bits take so many clocks each, begun anywhere within a clock.
  void send(unsigned byte, double clocks, bool stop = true) {
    const unsigned bits = (stop ? 0x200u : 0u) | byte << 1;
    for (unsigned bit = 0; bit < kLineBitsOfByte; ++bit) {
      at_ += clocks;
      const double whole = std::floor(at_);
      hold((bits >> bit & 1) != 0, static_cast<unsigned>(whole - held_));
      held_ = whole;
    }
  }
  std::vector<LinkEvent> received() {
    bench_.run();
    return bench_.take(bench_.unit.event);
  }
  double at_ = 0, held_ = 0;
  test::UnitBench<UartReceive> bench_;
};

LinkEvent byte_of(unsigned value) { return {LinkEventKind::kByte, LinkLength::from(value)}; }

/// The last bit is looked at after 9.5 bits, and may be half a bit off, less the clock in which the
/// start was seen.
TEST_F(UartReceiveTest, HearsASenderOfAnotherSpeed) {
  unsigned heard = 0;
  for (const unsigned divisor : {4u, 10u, 35u, 40u}) {
    const double tolerance = (0.5 - 1.0 / divisor) / 9.5;
    for (const double part : {-0.9, -0.5, 0.0, 0.5, 0.9}) {
      SCOPED_TRACE(divisor);
      SCOPED_TRACE(part);
      set(divisor);
      std::vector<LinkEvent> expected;
      for (unsigned byte = 0; byte < 256; ++byte) {
        send(byte, divisor * (1 + part * tolerance));
        hold(true, byte % 4);
        expected.push_back(byte_of(byte));
      }
      EXPECT_TRUE(test::same(received(), expected));
      ++heard;
    }
  }
  EXPECT_EQ(heard, 20u);
}

TEST_F(UartReceiveTest, NotOneThatIsTooFast) {
  set(40);
  for (unsigned byte = 0; byte < 256; ++byte) send(byte, 40 * 1.08);
  EXPECT_FALSE(test::same(received(), std::vector(256, byte_of(0))));
}

TEST_F(UartReceiveTest, TellsOfAMissingStopBit) {
  set(8);
  send(0x15, 8, false);
  hold(true, 20);
  send(0x51, 8);
  EXPECT_TRUE(
      test::same(received(), {{LinkEventKind::kBadByte, LinkLength::from(0x15)}, byte_of(0x51)}));
}

TEST_F(UartReceiveTest, DoesNotHearAShortDisturbance) {
  set(40);
  hold(false, 15);
  hold(true, 100);
  EXPECT_TRUE(received().empty());
  send(0xa5, 40);
  EXPECT_TRUE(test::same(received(), {byte_of(0xa5)}));
}

TEST_F(UartReceiveTest, DoesNotHearALineThatIsLow) {
  bench_.value(bench_.unit.divisor) = LineDivisor::from(8);
  hold(false, 1000);
  EXPECT_TRUE(received().empty());
}

TEST(UartSend, SendsAStartTheLowestBitFirstAndAStop) {
  test::UnitBench<UartSend> bench;
  for (unsigned i = 0; i < kLineBitsOfByte; ++i) {
    bench.feed(bench.unit.byte, {uint<4>::from(i), i == 9, {uint<4>(9), uint<8>(0x35)}});
  }
  bench.run();
  std::vector<uint<1>> expected;
  for (const bool bit : {false, true, false, true, false, true, true, false, false, true}) {
    expected.push_back(uint<1>(bit));
  }
  EXPECT_TRUE(test::same(bench.take(bench.unit.bit), expected));
}

}  // namespace
}  // namespace dynrt
