// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The link from pin to pin, against its model: the same bytes go to both, some of them wrong, and
// each byte of the answers, the memory and the registers must be the same. The memory behind the
// Verilog waits at random.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <verilated.h>

#include <cstring>
#include <deque>
#include <map>
#include <vector>

#include "Vboard_link.h"
#include "hls/bits.h"
#include "hls/random.h"
#include "host/link/link_frame.h"
#include "units/link_model.h"

namespace dynrt {
namespace {

using hls::testing::Random;
using Bytes = std::vector<std::uint8_t>;

constexpr unsigned kBytes = 16;
constexpr unsigned kDivisor = 5;
constexpr unsigned kMemory = 1 << 16;
constexpr LinkFacts kFacts{.name = "fast",
                           .clock_hz = 120'000'000,
                           .memory_bytes = kMemory,
                           .divisor = kDivisor,
                           .beat_bytes = kBytes,
                           .pixel_mhz = 40};

/// Bits of a token on the Verilog's pins.
template <class T, class Pins>
T token_of(const Pins& pins) {
  hls::Words<T> words{};
  std::memcpy(words.data(), &pins, std::min(sizeof(pins), sizeof(words)));
  return hls::unpack<T>(words.data());
}

/// The Verilog, with a memory, registers and the other end of the line.
class Board {
 public:
  explicit Board(std::uint64_t seed) : random_(seed) {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed) + 1);
    top_.rst_ni = 0;
    top_.rx_i = 1;
    for (unsigned i = 0; i < 64; ++i) clock();
    top_.rst_ni = 1;
  }

  /// A byte; its stop bit is missing if it is bad.
  void send(std::uint8_t byte, bool bad = false) {
    const unsigned bits = (bad ? 0u : 0x200u) | byte * 2u;
    for (unsigned bit = 0; bit < kLineBitsOfByte; ++bit) {
      top_.rx_i = bits >> bit & 1;
      for (unsigned i = 0; i < kDivisor; ++i) clock();
    }
    if (!bad) return;
    top_.rx_i = 1;
    for (unsigned i = 0; i < kDivisor; ++i) clock();
  }
  /// Until nothing has come for longer than a byte takes.
  Bytes received() {
    for (unsigned quiet = 0; quiet < 2 * kLineBitsOfByte * kDivisor + 500; ++quiet) {
      if (clock()) quiet = 0;
    }
    return std::exchange(received_, {});
  }

  Bytes memory = Bytes(kMemory);
  std::map<std::uint32_t, std::uint32_t> registers;
  unsigned register_writes = 0;

 private:
  struct Read {
    unsigned address, left;
  };

  /// One clock; tells whether the line was busy.
  bool clock() {
    top_.write_ready_i = random_.chance(0.3);
    top_.read_ready_i = random_.chance(0.3);
    top_.bus_ready_i = random_.chance(0.5);
    top_.beat_valid_i = !reads_.empty() && (held_ || random_.chance(0.2));
    if (top_.beat_valid_i) put_beat();
    top_.bus_rvalid_i = !words_.empty() && random_.chance(0.4);
    if (top_.bus_rvalid_i) top_.bus_rdata_i = words_.front();
    top_.clk_i = 0;
    top_.eval();
    const bool busy = listen();
    if (top_.rst_ni) exchange_tokens();
    top_.clk_i = 1;
    top_.eval();
    return busy;
  }

  void exchange_tokens() {
    if (top_.bus_rvalid_i) words_.pop_front();
    held_ = top_.beat_valid_i && !top_.beat_ready_o;
    if (top_.beat_valid_i && top_.beat_ready_o) {
      reads_.front().address += kBytes;
      if (reads_.front().left-- == 0) reads_.pop_front();
    }
    if (top_.write_valid_o && top_.write_ready_i) {
      const auto w = token_of<LinkWrite<kBytes>>(top_.write_data_o);
      for (unsigned b = 0; b < kBytes; ++b) {
        const std::size_t at = w.address.to_u64() + b;
        if (!w.mask.bit(b / 2) || at >= kMemory) continue;
        memory[at] = static_cast<std::uint8_t>(w.data[b / 2].to_u64() >> (8 * (b % 2)));
      }
    }
    if (top_.read_valid_o && top_.read_ready_i) {
      const auto r = token_of<LinkRead>(top_.read_data_o);
      reads_.push_back(
          {static_cast<unsigned>(r.address.to_u64()), static_cast<unsigned>(r.last.to_u64())});
    }
    if (top_.bus_valid_o && top_.bus_ready_i) {
      if (top_.bus_write_o) {
        registers[top_.bus_addr_o] = top_.bus_wdata_o;
        ++register_writes;
      } else {
        words_.push_back(registers[top_.bus_addr_o]);
      }
    }
  }
  void put_beat() {
    LinkBeat<kBytes> beat;
    for (unsigned b = 0; b < kBytes; ++b) {
      const std::size_t at = reads_.front().address + b;
      const unsigned byte = at < kMemory ? memory[at] : 0u;
      beat.data[b / 2] = beat.data[b / 2] | uint<16>::from(byte << (8 * (b % 2)));
    }
    beat.last = reads_.front().left == 0;
    const auto words = hls::pack(beat);
    std::memcpy(&top_.beat_data_i, words.data(), sizeof(words));
  }

  /// The other end of the board's line.
  bool listen() {
    if (!hears_) {
      if (top_.tx_o || !top_.rst_ni) return false;
      hears_ = true;
      heard_ = bits_ = 0;
    }
    if (heard_ % kDivisor == kDivisor / 2) bits_ |= unsigned{top_.tx_o} << heard_ / kDivisor;
    if (++heard_ < kLineBitsOfByte * kDivisor) return true;
    hears_ = false;
    EXPECT_EQ(bits_ & 0x201, 0x200u) << "a start bit and a stop bit";
    received_.push_back(static_cast<std::uint8_t>(bits_ >> 1));
    return true;
  }

  Random random_;
  VerilatedContext context_;
  Vboard_link top_{&context_};
  std::deque<Read> reads_;
  std::deque<std::uint32_t> words_;
  bool held_ = false;
  Bytes received_;
  bool hears_ = false;
  unsigned heard_ = 0, bits_ = 0;
};

void put(Bytes& to, std::uint64_t value, unsigned bytes) {
  for (unsigned i = 0; i < bytes; ++i) to.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

/// Requests that a host might make, in sequence but for some.
class Requests {
 public:
  explicit Requests(Random& random) : random_(random) {}
  void expect(std::uint8_t sequence) { sequence_ = sequence; }
  Bytes next() {
    const auto command = static_cast<unsigned>(1 + random_.below(5));
    const bool memory = command == 2 || command == 3;
    const bool writes = command == 2 || command == 4;
    unsigned length = 4 * static_cast<unsigned>(1 + random_.below(writes ? 30 : 16));
    unsigned address = 4 * static_cast<unsigned>(random_.below(1000));
    if (command == 2) address += 2 * static_cast<unsigned>(random_.below(8));
    if (command == 3) {
      length = kBytes * static_cast<unsigned>(1 + random_.below(kLinkReadBeats));
      address = kBytes * static_cast<unsigned>(random_.below(kMemory / kBytes));
    }
    if (random_.below(40) == 0) ++length;  // refused
    if (random_.below(20) == 0) --sequence_;
    Bytes bytes = {static_cast<std::uint8_t>(command), sequence_};
    put(bytes, command == 1 ? 0 : length, 2);
    put(bytes, memory ? address : address % 256, 4);
    for (unsigned i = 0; writes && i < length; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(
          random_.below(8) == 0 ? kLinkEscape + random_.below(2) : random_.below(256)));
    }
    if (command != 1) ++sequence_;
    return bytes;
  }

 private:
  Random& random_;
  std::uint8_t sequence_ = 0;
};

Bytes framed(Bytes bytes) {
  Bytes line;
  host::append_framed(line, std::move(bytes));
  return line;
}

/// Loses, changes, repeats or adds a byte.
void spoil(Bytes& line, Random& random) {
  const auto at = line.begin() + static_cast<std::ptrdiff_t>(random.below(line.size()));
  switch (random.below(4)) {
    case 0:
      line.erase(at);
      break;
    case 1:
      *at ^= static_cast<std::uint8_t>(1u << random.below(8));
      break;
    case 2:
      line.insert(at, *at);
      break;
    default:
      line.insert(at, static_cast<std::uint8_t>(random.below(256)));
  }
}

const Bytes kIdentify = framed({1, 42, 0, 0, 0, 0, 0, 0});

/// The sequence that the board expects next, by the answer to kIdentify that ends these bytes.
std::uint8_t expected_by(const Bytes& line) {
  Bytes bytes;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == kLinkFlag) continue;
    const bool escapes = line[i] == kLinkEscape;
    bytes.push_back(escapes ? line[++i] ^ kLinkEscaped : line[i]);
  }
  constexpr std::size_t kFromEnd = 4 * (kLinkIdentityWords - kLinkFacts) - 1 + kLinkCrcBytes;
  return bytes.at(bytes.size() - kFromEnd);
}

void compare(std::uint64_t seed, unsigned requests, bool mistakes) {
  SCOPED_TRACE(fmt::format("seed {}", seed));
  Random random(seed);
  Board board(seed);
  std::map<std::uint32_t, std::uint32_t> registers;
  unsigned register_writes = 0;
  LinkModel<kBytes> model(kFacts, {[&](std::uint32_t address, std::uint32_t value) {
                                     registers[address] = value;
                                     ++register_writes;
                                   },
                                   [&](std::uint32_t address) { return registers[address]; }});
  Requests next(random);
  std::size_t answered = 0;
  unsigned spoilt = 0;
  const Bytes identification = model.answer(kIdentify);
  for (const std::uint8_t byte : kIdentify) board.send(byte);
  ASSERT_EQ(board.received(), identification);
  for (unsigned i = 0; i < requests; ++i) {
    // A few at once; fewer than the board keeps.
    Bytes expected;
    const auto send = [&](const Bytes& bytes) {
      const Bytes answer = model.answer(bytes);
      expected.insert(expected.end(), answer.begin(), answer.end());
      for (const std::uint8_t byte : bytes) board.send(byte);
    };
    for (std::uint64_t n = random.below(4); n > 0; --n) {
      Bytes line = framed(next.next());
      if (mistakes && random.below(4) == 0) {
        spoil(line, random);
        ++spoilt;
      }
      send(line);
      if (!mistakes || random.below(8) != 0) continue;
      const Bytes answer = model.answer_bad_byte();
      expected.insert(expected.end(), answer.begin(), answer.end());
      board.send(0x31, true);
    }
    if (mistakes) {
      send(kIdentify);
      next.expect(expected_by(expected));
    }
    const Bytes received = board.received();
    ASSERT_EQ(received, expected) << "request " << i;
    answered += received.size();
  }
  ASSERT_EQ(board.memory, model.memory());
  ASSERT_EQ(board.registers, registers);
  ASSERT_EQ(board.register_writes, register_writes);
  EXPECT_GT(answered, 10 * requests);
  EXPECT_EQ(spoilt > requests / 8, mistakes);
  EXPECT_GT(model.writes(), requests / 8);
  EXPECT_GT(register_writes, requests / 8);
}

TEST(BoardLink, IsTheModel) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) compare(seed, 150, false);
}
TEST(BoardLink, IsTheModelWhereBytesAreWrong) {
  for (std::uint64_t seed = 11; seed <= 13; ++seed) compare(seed, 150, true);
}

/// Samples of the line that are wrong, as by noise: the board never writes what nobody sent.
TEST(BoardLink, IsReadyBehindNoise) {
  Board board(5);
  LinkModel<kBytes> model(kFacts,
                          {[](std::uint32_t, std::uint32_t) {}, [](std::uint32_t) { return 0u; }});
  Random random(5);
  for (unsigned i = 0; i < 300; ++i) {
    board.send(static_cast<std::uint8_t>(random.below(256)), random.below(3) == 0);
  }
  board.received();
  for (const std::uint8_t byte : kIdentify) board.send(byte);
  const Bytes received = board.received();
  const Bytes expected = model.answer(kIdentify);
  ASSERT_GE(received.size(), expected.size());
  EXPECT_TRUE(std::equal(expected.rbegin(), expected.rend(), received.rbegin()));
  EXPECT_EQ(board.register_writes, 0u);
  EXPECT_EQ(board.memory, Bytes(kMemory));
}

}  // namespace
}  // namespace dynrt
