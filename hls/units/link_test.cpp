// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "units/link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <vector>

#include "hls/random.h"
#include "units/link_model.h"

namespace dynrt {
namespace {

using Bytes = std::vector<std::uint8_t>;
using hls::testing::Random;

std::uint32_t crc_of(const Bytes& bytes) {
  Crc crc = kCrcStart;
  for (const std::uint8_t byte : bytes) crc = crc_step(crc, uint<8>::from(byte));
  return static_cast<std::uint32_t>((~crc).to_u64());
}

TEST(LinkCrc, IsCrc32C) {
  EXPECT_EQ(crc_of({'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0xe3069283u);  // RFC 3720
  EXPECT_EQ(crc_of(Bytes(32, 0)), 0x8a9136aau);
}

/// What a wrong bit that many bits before the end of a frame does to the CRC.
std::vector<std::uint32_t> syndromes(std::size_t bits) {
  std::vector<std::uint32_t> all;
  std::uint32_t crc = 1u << 31;  // in the last bit
  for (std::size_t i = 0; i < bits; ++i) {
    all.push_back(crc);
    crc = (crc >> 1) ^ ((crc & 1) != 0 ? kCrcPolynomial : 0);
  }
  return all;
}

/// No one to five wrong bits go unseen in the longest frame: an odd number never does, as the
/// polynomial has the factor x + 1; two or four would need two pairs with one sum.
TEST(LinkCrc, SeesFiveWrongBitsInTheLongestFrame) {
  const auto one = syndromes(8 * (kLinkHeaderBytes + kLinkDataBytes + kLinkCrcBytes));
  EXPECT_EQ(std::popcount(kCrcPolynomial) % 2, 1) << "and that of x to the 32nd makes them even";
  std::vector<std::uint32_t> two;
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) two.push_back(one[i] ^ one[j]);
  }
  std::ranges::sort(two);
  EXPECT_NE(two.front(), 0u);
  EXPECT_EQ(std::ranges::adjacent_find(two), two.end());
}

void put(Bytes& to, std::uint64_t value, unsigned bytes) {
  for (unsigned i = 0; i < bytes; ++i) to.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}
Bytes framed(Bytes bytes) {
  put(bytes, crc_of(bytes), kLinkCrcBytes);
  Bytes line = {kLinkFlag};
  for (const std::uint8_t byte : bytes) {
    const bool escapes = byte == kLinkFlag || byte == kLinkEscape;
    if (escapes) line.push_back(kLinkEscape);
    line.push_back(escapes ? byte ^ kLinkEscaped : byte);
  }
  line.push_back(kLinkFlag);
  return line;
}
Bytes request(LinkCommand command, unsigned sequence, unsigned length, std::uint32_t address,
              const Bytes& data = {}) {
  Bytes bytes = {static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(sequence)};
  put(bytes, length, 2);
  put(bytes, address, 4);
  bytes.insert(bytes.end(), data.begin(), data.end());
  return framed(std::move(bytes));
}

struct Answer {
  unsigned kind = 0, sequence = 0, length = 0;
  Bytes data;
  friend bool operator==(const Answer&, const Answer&) = default;
};
/// The frames on the line, each of which must be whole.
std::vector<Answer> answers_of(const Bytes& line) {
  std::vector<Answer> answers;
  Bytes bytes;
  bool escaped = false;
  for (const std::uint8_t raw : line) {
    if (raw == kLinkFlag) {
      if (bytes.empty()) continue;
      EXPECT_GE(bytes.size(), kLinkAnswerBytes + kLinkCrcBytes);
      std::uint32_t crc = 0;
      for (unsigned i = 4; i > 0; --i) crc = crc << 8 | bytes[bytes.size() - 5 + i];
      bytes.resize(bytes.size() - kLinkCrcBytes);
      EXPECT_EQ(crc, crc_of(bytes));
      answers.push_back({bytes[0], bytes[1], bytes[2] + 256u * bytes[3],
                         Bytes(bytes.begin() + kLinkAnswerBytes, bytes.end())});
      EXPECT_EQ(answers.back().length, answers.back().data.size());
      bytes.clear();
    } else if (raw == kLinkEscape) {
      escaped = true;
    } else {
      bytes.push_back(escaped ? raw ^ kLinkEscaped : raw);
      escaped = false;
    }
  }
  EXPECT_TRUE(bytes.empty()) << "the line ends within a frame";
  return answers;
}
unsigned answer_to(LinkCommand command) { return kLinkAnswer | static_cast<unsigned>(command); }
Answer expects(unsigned sequence) { return {kLinkExpected, sequence, 0, {}}; }

template <class T>
class LinkTest : public testing::Test {
 protected:
  static constexpr unsigned kBytes = T::value;
  LinkTest() { ask(request(LinkCommand::kIdentify, 0, 0, 0)); }
  std::vector<Answer> ask(const Bytes& line) { return answers_of(model_.answer(line)); }
  Bytes random_bytes(std::size_t count) {
    Bytes bytes(count);
    for (auto& byte : bytes) {
      const std::uint64_t r = random_.next();  // an eighth of them need an escape
      byte = static_cast<std::uint8_t>(r % 8 == 0 ? kLinkEscape + (r >> 8) % 2 : r >> 16);
    }
    return bytes;
  }
  Random random_{1};
  std::map<std::uint32_t, std::uint32_t> registers_;
  unsigned register_writes_ = 0;
  LinkModel<kBytes> model_{{.name = "fast",
                            .clock_hz = 120'000'000,
                            .memory_bytes = 1 << 16,
                            .divisor = 40,
                            .beat_bytes = kBytes},
                           {[this](std::uint32_t address, std::uint32_t value) {
                              ++register_writes_;
                              registers_[address] = value;
                            },
                            [this](std::uint32_t address) { return registers_[address]; }}};
};
template <unsigned N>
using Number = std::integral_constant<unsigned, N>;
using BeatSizes = testing::Types<Number<2>, Number<8>, Number<16>>;
TYPED_TEST_SUITE(LinkTest, BeatSizes);

TYPED_TEST(LinkTest, SaysWhatItIs) {
  this->ask(request(LinkCommand::kReadRegisters, 0, 4, 0));
  const auto answers = this->ask(request(LinkCommand::kIdentify, 99, 0, 0));
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].kind, answer_to(LinkCommand::kIdentify));
  EXPECT_EQ(answers[0].sequence, 99u);
  ASSERT_EQ(answers[0].length, 4 * kLinkIdentityWords);
  const Bytes& data = answers[0].data;
  EXPECT_EQ((Bytes{data.begin(), data.begin() + 8}),
            (Bytes{'D', 'L', 'N', 'K', kLinkVersion, 1, TestFixture::kBytes, 0}))
      << "it expects the second request";
  EXPECT_STREQ(reinterpret_cast<const char*>(&data[4 * kLinkName]), "fast");
}

TYPED_TEST(LinkTest, WritesAndReadsMemoryFromAnyHalf) {
  constexpr unsigned kMost = kLinkReadBytes<TestFixture::kBytes>;
  Bytes expected = this->model_.memory();
  unsigned sequence = 0;
  for (unsigned i = 0; i < 300; ++i) {
    const unsigned length =
        2 * (1 + static_cast<unsigned>(this->random_.below(kLinkDataBytes / 2)));
    const unsigned address = 2 * static_cast<unsigned>(this->random_.below(2000));
    const Bytes data = this->random_bytes(length);
    std::ranges::copy(data, expected.begin() + address);
    ASSERT_EQ(this->ask(request(LinkCommand::kWriteMemory, sequence, length, address, data)),
              (std::vector<Answer>{{answer_to(LinkCommand::kWriteMemory), sequence % 256, 0, {}}}));
    sequence = (sequence + 1) % 256;
    const unsigned from = kMost * static_cast<unsigned>(this->random_.below(4000 / kMost));
    const auto answers = this->ask(request(LinkCommand::kReadMemory, sequence, kMost, from));
    ASSERT_EQ(answers.size(), 1u);
    ASSERT_EQ(answers[0].kind, answer_to(LinkCommand::kReadMemory));
    ASSERT_EQ(answers[0].data, Bytes(expected.begin() + from, expected.begin() + from + kMost));
    sequence = (sequence + 1) % 256;
  }
  EXPECT_EQ(this->model_.memory(), expected);
}

TYPED_TEST(LinkTest, WritesAndReadsRegisters) {
  this->ask(request(LinkCommand::kWriteRegisters, 0, 8, 0x100, {1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(this->registers_,
            (std::map<std::uint32_t, std::uint32_t>{{0x100, 0x04030201}, {0x104, 0x08070605}}));
  EXPECT_EQ(
      this->ask(request(LinkCommand::kReadRegisters, 1, 12, 0xfc)),
      (std::vector<Answer>{
          {answer_to(LinkCommand::kReadRegisters), 1, 12, {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8}}}));
}

TYPED_TEST(LinkTest, AnswersARepeatedWriteAndDoesNotRepeatIt) {
  const Bytes write = request(LinkCommand::kWriteRegisters, 0, 4, 12, {1, 0, 0, 0});
  const auto first = this->ask(write);
  EXPECT_EQ(this->ask(write), first);
  EXPECT_EQ(this->register_writes_, 1u);
  this->ask(request(LinkCommand::kWriteRegisters, 1, 4, 12, {2, 0, 0, 0}));
  EXPECT_EQ(this->register_writes_, 2u) << "the next is still expected";
  const Bytes read = request(LinkCommand::kReadRegisters, 2, 4, 12);
  const auto word = this->ask(read);
  EXPECT_EQ(this->ask(read), word);
  EXPECT_EQ(this->ask(request(LinkCommand::kReadRegisters, 3, 4, 12)).at(0).data, word.at(0).data);
}

TYPED_TEST(LinkTest, DoesNothingAfterAResetBeforeItIsAskedWhatItIs) {
  LinkModel<TestFixture::kBytes> model(
      {.name = {}, .memory_bytes = 64, .beat_bytes = TestFixture::kBytes}, {});
  const Bytes data(4, 7);
  for (unsigned sequence = 0; sequence < 256; ++sequence) {
    const Bytes write = request(LinkCommand::kWriteMemory, sequence, 4, 0, data);
    ASSERT_EQ(answers_of(model.answer(write)), (std::vector<Answer>{expects(0)})) << sequence;
  }
  EXPECT_EQ(model.writes(), 0u);
}

TYPED_TEST(LinkTest, ExpectsTheMissingRequest) {
  const Bytes data(4, 7);
  for (const unsigned ahead : {1u, 2u, 100u}) {
    EXPECT_EQ(this->ask(request(LinkCommand::kWriteMemory, ahead, 4, 0, data)),
              (std::vector<Answer>{expects(0)}));
  }
  EXPECT_EQ(this->model_.writes(), 0u);
  EXPECT_EQ(this->ask(request(LinkCommand::kWriteMemory, 0, 4, 0, data)).at(0).kind,
            answer_to(LinkCommand::kWriteMemory));
}

/// A frame with one mistake writes nothing; sent again, it does.
TYPED_TEST(LinkTest, WritesNothingOfAFrameWithAMistake) {
  const Bytes data = this->random_bytes(64);
  const Bytes frame = request(LinkCommand::kWriteMemory, 0, 64, 128, data);
  unsigned mistakes = 0;
  for (std::size_t at = 1; at + 1 < frame.size(); ++at) {
    for (unsigned kind = 0; kind < 3 + 8; ++kind) {
      Bytes wrong = frame;
      if (kind == 0) wrong.erase(wrong.begin() + static_cast<std::ptrdiff_t>(at));
      if (kind == 1) wrong.insert(wrong.begin() + static_cast<std::ptrdiff_t>(at), wrong[at]);
      if (kind == 2) wrong.insert(wrong.begin() + static_cast<std::ptrdiff_t>(at), 0x55);
      if (kind > 2) wrong[at] ^= static_cast<std::uint8_t>(1u << (kind - 3));
      if (kind == 1 && frame[at] == kLinkEscape) continue;  // an escape twice is an escape
      const auto answers = this->ask(wrong);
      ASSERT_GE(answers.size(), 1u);
      for (const Answer& a : answers)
        ASSERT_EQ(a, expects(0)) << "mistake " << kind << " at " << at;
      ++mistakes;
    }
  }
  EXPECT_EQ(this->model_.writes(), 0u);
  EXPECT_GT(mistakes, 700u) << "mistakes were made";
  ASSERT_EQ(this->ask(frame).at(0).kind, answer_to(LinkCommand::kWriteMemory));
  EXPECT_TRUE(std::ranges::equal(data, std::span(this->model_.memory()).subspan(128, 64)));
}

TYPED_TEST(LinkTest, RefusesWhatItCannotDo) {
  const auto refuses = [this](const Bytes& line) {
    return this->ask(line) == std::vector<Answer>{{kLinkRefused, 0, 0, {}}};
  };
  EXPECT_TRUE(refuses(request(LinkCommand{9}, 0, 0, 0)));
  EXPECT_TRUE(refuses(request(LinkCommand::kWriteMemory, 0, 3, 0, {1, 2, 3})));
  EXPECT_TRUE(refuses(request(LinkCommand::kWriteMemory, 0, 2, 1, {1, 2})));
  EXPECT_TRUE(refuses(request(LinkCommand::kWriteMemory, 0, 4, 0, {1, 2}))) << "two bytes missing";
  EXPECT_TRUE(refuses(request(LinkCommand::kWriteMemory, 0, 2, 1u << 25, {1, 2})));
  EXPECT_TRUE(refuses(request(LinkCommand::kReadMemory, 0, 0, 0)));
  EXPECT_TRUE(refuses(request(LinkCommand::kReadMemory, 0, TestFixture::kBytes, 1)));
  EXPECT_TRUE(refuses(request(LinkCommand::kReadMemory, 0,
                              kLinkReadBytes<TestFixture::kBytes> + TestFixture::kBytes, 0)));
  EXPECT_TRUE(refuses(request(LinkCommand::kReadRegisters, 0, 68, 0)));
  EXPECT_TRUE(refuses(request(LinkCommand::kReadRegisters, 0, 4, 2)));
  EXPECT_TRUE(refuses(request(LinkCommand::kReadRegisters, 0, 4, 1u << 26)));
  EXPECT_EQ(this->model_.writes(), 0u);
}

TYPED_TEST(LinkTest, FindsAFrameBehindNoise) {
  for (unsigned i = 0; i < 50; ++i) {
    this->model_.answer(this->random_bytes(this->random_.below(40)));
    this->model_.answer_bad_byte();
    const auto answers = this->ask(request(LinkCommand::kIdentify, i, 0, 0));
    ASSERT_FALSE(answers.empty());
    ASSERT_EQ(answers.back().kind, answer_to(LinkCommand::kIdentify));
  }
  EXPECT_EQ(this->model_.writes(), 0u);
}

}  // namespace
}  // namespace dynrt
