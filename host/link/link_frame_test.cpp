// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/link/link_frame.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string_view>

namespace dynrt::host {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(LinkFrame, IsAsTheFormatSays) {
  const Bytes data = {0x11, 0x7e, 0x22, 0x7d};
  Bytes line;
  append_frame(line, {.command = LinkCommand::kWriteMemory,
                      .sequence = 5,
                      .length = 4,
                      .address = 0x01020304,
                      .data = data});
  const Bytes plain = {2, 5, 4, 0, 4, 3, 2, 1, 0x11, 0x7e, 0x22, 0x7d};
  const std::uint32_t crc = link_crc(plain);
  const Bytes begin = {0x7e, 2, 5, 4, 0, 4, 3, 2, 1, 0x11, 0x7d, 0x5e, 0x22, 0x7d, 0x5d};
  ASSERT_EQ(line.size(), begin.size() + 4 + 1) << "no byte of this CRC needs an escape";
  EXPECT_EQ(Bytes(line.begin(), line.begin() + 15), begin);
  for (unsigned i = 0; i < 4; ++i) EXPECT_EQ(line[15 + i], crc >> (8 * i) & 0xff);
  EXPECT_EQ(line.back(), 0x7e);
}

TEST(LinkFrame, HasCrc32C) {
  constexpr std::string_view kDigits = "123456789";
  EXPECT_EQ(link_crc(Bytes(kDigits.begin(), kDigits.end())), 0xe3069283u);  // RFC 3720
}

/// An answer has the frame of a request without an address.
Bytes answer_on_line(std::uint8_t kind, std::uint8_t sequence, const Bytes& data) {
  Bytes bytes = {kind, sequence, static_cast<std::uint8_t>(data.size()),
                 static_cast<std::uint8_t>(data.size() >> 8)};
  bytes.insert(bytes.end(), data.begin(), data.end());
  Bytes line;
  append_framed(line, bytes);
  return line;
}
std::vector<LinkAnswerFrame> read(AnswerReader& reader, const Bytes& line) {
  std::vector<LinkAnswerFrame> answers;
  for (const std::uint8_t byte : line) {
    if (auto answer = reader.take(byte)) answers.push_back(*answer);
  }
  return answers;
}

TEST(AnswerReader, ReadsEveryByteValue) {
  Bytes data(256);
  std::iota(data.begin(), data.end(), std::uint8_t{0});
  AnswerReader reader;
  const auto answers = read(reader, answer_on_line(0x83, 200, data));
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].kind, 0x83);
  EXPECT_EQ(answers[0].sequence, 200);
  EXPECT_EQ(answers[0].data, data);
  EXPECT_EQ(reader.bad_frames(), 0u);
  EXPECT_FALSE(reader.in_frame());
}

TEST(AnswerReader, DropsAFrameWithAMistakeAndReadsTheNext) {
  const Bytes good = answer_on_line(0x83, 1, {1, 2, 3, 4});
  for (std::size_t at = 1; at + 1 < good.size(); ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      Bytes wrong = good;
      wrong[at] ^= static_cast<std::uint8_t>(1u << bit);
      AnswerReader reader;
      EXPECT_TRUE(read(reader, wrong).empty()) << at;
      EXPECT_GE(reader.bad_frames(), 1u);
      EXPECT_EQ(read(reader, good).size(), 1u);
    }
  }
}

TEST(AnswerReader, KeepsNoFrameThatNeverEnds) {
  AnswerReader reader;
  for (unsigned i = 0; i < 100'000; ++i) EXPECT_FALSE(reader.take(0x11));
  EXPECT_TRUE(reader.in_frame());
  EXPECT_EQ(reader.bytes(), 100'000u);
  EXPECT_EQ(read(reader, answer_on_line(0x81, 1, {})).size(), 1u);
  EXPECT_EQ(reader.bad_frames(), 1u);
}

TEST(WriteFrames, EndWhereBeatsEnd) {
  const MemoryBytes parts[] = {{500, Bytes(1000)}, {4096, Bytes(2)}};
  const auto frames = write_frames(parts);
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames[0].address, 500u);
  EXPECT_EQ(frames[0].length, 12u);
  EXPECT_EQ(frames[1].address, 512u);
  EXPECT_EQ(frames[1].length, 512u);
  EXPECT_EQ(frames[2].address, 1024u);
  EXPECT_EQ(frames[2].length, 476u);
  EXPECT_EQ(frames[3].address, 4096u);
  EXPECT_EQ(frames[3].length, 2u);
}

}  // namespace
}  // namespace dynrt::host
