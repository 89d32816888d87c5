// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The ring where it fills up: no byte of a request that waits is ever overwritten.
#include "units/link_receive.h"

#include <gtest/gtest.h>

#include <vector>

#include "units/test_bench.h"

namespace dynrt {
namespace {

using Bytes = std::vector<unsigned>;

class LinkReceiveTest : public testing::Test {
 protected:
  enum class Begins { kWithFlag, kWithoutFlag };
  /// A write of so many bytes, all with one value that needs no escape. In its middle `room` bytes
  /// of the ring are freed.
  void send(unsigned data, unsigned value, unsigned room = 0, Begins begins = Begins::kWithFlag) {
    Bytes bytes = {2, 0, data % 256, data / 256, 0, 0, 0, 0};
    bytes.resize(kLinkHeaderBytes + data, value);
    Crc crc = kCrcStart;
    for (const unsigned byte : bytes) crc = crc_step(crc, uint<8>::from(byte));
    for (unsigned i = 0; i < kLinkCrcBytes; ++i) {
      bytes.push_back(static_cast<unsigned>((~crc).to_u64() >> (8 * i)) % 256);
    }
    if (begins == Begins::kWithFlag) event(kLinkFlag);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (room != 0 && i == bytes.size() / 2) free(room);
      const unsigned byte = bytes[i];
      const bool escapes = byte == kLinkFlag || byte == kLinkEscape;
      if (escapes) event(kLinkEscape);
      event(escapes ? byte ^ kLinkEscaped : byte);
    }
    event(kLinkFlag);
  }
  void event(unsigned byte) {
    bench_.feed(bench_.unit.event, {LinkEventKind::kByte, LinkLength::from(byte)});
  }
  void free(unsigned room) {
    bench_.feed(bench_.unit.event, {LinkEventKind::kFree, LinkLength::from(room)});
  }
  std::vector<LinkRequest> requests() {
    bench_.run();
    return bench_.take(bench_.unit.request);
  }
  /// Whether the ring still holds a request's data.
  bool holds(const LinkRequest& request, unsigned value) {
    for (unsigned i = 0; i < request.room.to_u64(); ++i) {
      const auto at = (request.start.to_u64() + i) % kLinkRingBytes;
      if (bench_.rows(bench_.unit.ring)[at] != uint<8>::from(value)) return false;
    }
    return true;
  }
  test::UnitBench<LinkReceive> bench_;
};

TEST_F(LinkReceiveTest, PassesOnAsBadWhatTheRingHasNoRoomFor) {
  constexpr unsigned kFull = kLinkRingBytes / kLinkDataBytes;
  for (unsigned i = 0; i < kFull; ++i) send(kLinkDataBytes, i);
  const std::vector<LinkRequest> waiting = requests();
  ASSERT_EQ(waiting.size(), kFull);
  for (unsigned round = 0; round < 5; ++round) send(2, 99);
  const std::vector<LinkRequest> more = requests();
  ASSERT_EQ(more.size(), 5u);
  for (const LinkRequest& r : more) EXPECT_FALSE(r.good);
  for (unsigned i = 0; i < kFull; ++i) {
    EXPECT_TRUE(waiting[i].good);
    EXPECT_TRUE(holds(waiting[i], i)) << i;
  }
  free(kLinkDataBytes);
  for (unsigned round = 0; round < 5; ++round) free(0);
  send(kLinkDataBytes, 77);
  const std::vector<LinkRequest> last = requests();
  ASSERT_EQ(last.size(), 1u);
  EXPECT_TRUE(last[0].good);
  EXPECT_TRUE(holds(last[0], 77));
  for (unsigned i = 1; i < kFull; ++i) EXPECT_TRUE(holds(waiting[i], i)) << i;
}

TEST_F(LinkReceiveTest, TakesNoFrameOfWhichOnlyTheEndFoundRoom) {
  for (unsigned used = 0; used < kLinkRingBytes; used += kLinkDataBytes) send(kLinkDataBytes, 1);
  requests();
  send(kLinkDataBytes, 2, kLinkDataBytes);
  send(kLinkDataBytes, 3);
  const std::vector<LinkRequest> all = requests();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_FALSE(all[0].good) << "its first bytes are not in the ring";
  EXPECT_TRUE(all[1].good);
  EXPECT_TRUE(holds(all[1], 3));
}

TEST_F(LinkReceiveTest, AsksForRoomThoughTheFirstByteIsBad) {
  constexpr unsigned kFull = kLinkRingBytes / kLinkDataBytes;
  for (unsigned i = 0; i < kFull; ++i) send(kLinkDataBytes, i);
  const std::vector<LinkRequest> waiting = requests();
  bench_.feed(bench_.unit.event, {LinkEventKind::kBadByte, LinkLength()});
  send(kLinkDataBytes, 99, 0, Begins::kWithoutFlag);
  const std::vector<LinkRequest> more = requests();
  ASSERT_EQ(more.size(), 1u);
  EXPECT_FALSE(more[0].good);
  for (unsigned i = 0; i < kFull; ++i) EXPECT_TRUE(holds(waiting[i], i)) << i;
}

TEST_F(LinkReceiveTest, DropsWhatComesWhileAsManyWaitAsMay) {
  for (unsigned i = 0; i < kLinkWaiting + 3; ++i) send(2, i);
  const std::vector<LinkRequest> waiting = requests();
  ASSERT_EQ(waiting.size(), kLinkWaiting);
  free(2);
  send(2, 50);
  send(2, 51);
  const std::vector<LinkRequest> next = requests();
  ASSERT_EQ(next.size(), 1u);
  EXPECT_TRUE(holds(next[0], 50));
  for (unsigned i = 0; i < kLinkWaiting; ++i) EXPECT_TRUE(holds(waiting[i], i));
}

TEST_F(LinkReceiveTest, TakesNoFrameThatIsTooLong) {
  for (const unsigned data : {kLinkDataBytes + 2, 1000u, 1100u, 5000u}) send(data, 1);
  send(4, 2);
  const std::vector<LinkRequest> all = requests();
  ASSERT_EQ(all.size(), 5u);
  for (unsigned i = 0; i < 4; ++i) {
    EXPECT_FALSE(all[i].good && all[i].whole && all[i].length.to_u64() <= kLinkDataBytes) << i;
  }
  EXPECT_TRUE(all[4].good);
  EXPECT_TRUE(holds(all[4], 2));
}

}  // namespace
}  // namespace dynrt
