// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board's end of the line as a program: the native units of the link with a memory and
// registers behind them. Bytes in, bytes out; there are no clocks.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "units/link.h"

namespace dynrt {

/// What a board says of itself.
struct LinkFacts {
  std::string_view name;  ///< of the configuration, at most kLinkNameBytes
  std::uint32_t clock_hz = 0;
  std::uint32_t memory_bytes = 0;
  std::uint32_t divisor = 0;
  unsigned beat_bytes = 0;
  unsigned pixel_mhz = 0;  ///< of a display; 0: there is none
};
constexpr LinkWords identity_of(const LinkFacts& facts) {
  std::array<std::uint32_t, kLinkIdentityWords> words{};
  words[kLinkMagic] = kLinkMagicValue;
  words[kLinkFacts] = kLinkVersion | facts.beat_bytes << 16 | facts.pixel_mhz << 24;
  words[kLinkClockHz] = facts.clock_hz;
  words[kLinkMemoryBytes] = facts.memory_bytes;
  words[kLinkDivisor] = facts.divisor;
  for (unsigned i = 0; i < facts.name.size() && i < kLinkNameBytes; ++i) {
    const auto letter = static_cast<unsigned char>(facts.name[i]);
    words[kLinkName + i / 4] |= std::uint32_t{letter} << (8 * (i % 4));
  }
  LinkWords identity;
  for (unsigned i = 0; i < kLinkIdentityWords; ++i) identity[i] = uint<32>::from(words[i]);
  return identity;
}

/// The registers behind the link.
struct LinkBus {
  std::function<void(std::uint32_t address, std::uint32_t value)> write;
  std::function<std::uint32_t(std::uint32_t address)> read;
};

template <unsigned Bytes>
class LinkModel {
 public:
  LinkModel(const LinkFacts& facts, LinkBus bus) : bus_(std::move(bus)) {
    *link_.identity = identity_of(facts);
    memory_.resize(facts.memory_bytes);
  }

  std::vector<std::uint8_t>& memory() { return memory_; }
  /// Beats that came for the memory.
  std::uint64_t writes() const { return writes_; }

  /// The board's answer to bytes on the line, to the last of them.
  std::vector<std::uint8_t> answer(std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> out;
    for (const std::uint8_t byte : bytes) {
      put({LinkEventKind::kByte, LinkLength::from(byte)});
      take(out);
    }
    return out;
  }
  /// A byte without a stop bit.
  std::vector<std::uint8_t> answer_bad_byte() {
    std::vector<std::uint8_t> out;
    put({LinkEventKind::kBadByte, LinkLength(0)});
    take(out);
    return out;
  }

 private:
  void put(const LinkEvent& event) {
    link_.link_receive.event.queue()->push(event);
    do {
      join_.run();
    } while (serve());
  }
  void take(std::vector<std::uint8_t>& out) {
    while (!link_.bytes->empty()) {
      out.push_back(static_cast<std::uint8_t>(link_.bytes->pop().data.to_u64()));
    }
  }

  /// What the link asks for; false if it asks for nothing.
  bool serve() {
    bool any = false;
    for (; !link_.write->empty(); any = true) write(link_.write->pop());
    for (; !link_.read->empty(); any = true) read(link_.read->pop());
    for (; !link_.access->empty(); any = true) {
      const BusAccess a = link_.access->pop();
      const auto address = static_cast<std::uint32_t>(a.address.to_u64());
      if (a.write) {
        bus_.write(address, static_cast<std::uint32_t>(a.data.to_u64()));
      } else {
        link_.word->push(uint<32>::from(bus_.read(address)));
      }
    }
    return any;
  }
  void write(const LinkWrite<Bytes>& w) {
    ++writes_;
    for (unsigned b = 0; b < Bytes; ++b) {
      const std::uint64_t at = w.address.to_u64() + b;
      if (!w.mask.bit(b / 2) || at >= memory_.size()) continue;
      memory_[at] = static_cast<std::uint8_t>(w.data[b / 2].to_u64() >> (8 * (b % 2)));
    }
  }
  void read(const LinkRead& r) {
    for (unsigned i = 0; i <= r.last.to_u64(); ++i) {
      LinkBeat<Bytes> beat;
      for (unsigned b = 0; b < Bytes; ++b) {
        const std::uint64_t at = r.address.to_u64() + i * Bytes + b;
        const unsigned byte = at < memory_.size() ? memory_[at] : 0u;
        beat.data[b / 2] = beat.data[b / 2] | uint<16>::from(byte << (8 * (b % 2)));
      }
      beat.last = i == r.last.to_u64();
      link_.beat->push(beat);
    }
  }

  hls::Join join_;
  Link<Bytes> link_{join_, LinkLine::kBytes};
  LinkBus bus_;
  std::vector<std::uint8_t> memory_;
  std::uint64_t writes_ = 0;
};

}  // namespace dynrt
