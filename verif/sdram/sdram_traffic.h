// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Traffic for a memory port: random reads and writes of all lengths, in bursts and with pauses.
#pragma once

#include <cstdint>
#include <memory>
#include <random>

#include "sdram/sdram_bench.h"

namespace dynrt::verif {

/// How a channel behaves for some hundred clocks.
struct SdramMood {
  unsigned busy = 0;        ///< percent of the clocks in which a request waits
  unsigned sequential = 0;  ///< percent of the requests that follow the one before
};

/// Reads and writes over a small part of the memory, so that they meet, and over all of it.
template <unsigned PortBytes>
class RandomTraffic {
 public:
  using Types = SdramPortTypes<PortBytes>;
  explicit RandomTraffic(unsigned seed) : random_(seed) {}

  SdramTraffic<PortBytes> traffic() {
    return {.read = [this] { return read(); },
            .write = [this] { return write(); },
            .beat_ready =
                [this] {
                  change();
                  return below(100) < beats_;
                }};
  }
  /// No more requests.
  void stop() { stopped_ = true; }

 private:
  unsigned below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }
  /// In each clock.
  void change() {
    if (left_-- != 0) return;
    left_ = 100 + below(900);
    constexpr unsigned kBusy[] = {0, 5, 50, 100};
    constexpr unsigned kSequential[] = {0, 50, 100};
    reads_ = {kBusy[below(4)], kSequential[below(3)]};
    writes_ = {kBusy[below(4)], kSequential[below(3)]};
    beats_ = below(4) == 0 ? 20 : 100;
    near_ = below(2) == 0;
    mask_ = below(3);
  }
  std::uint32_t place(const SdramMood& mood, std::uint32_t& next, unsigned bytes) {
    if (below(100) >= mood.sequential) {
      next = near_ ? below(1 << 13) : below(1u << kSdramAddressBits);
    }
    const std::uint32_t address = next & ~(bytes - 1) & ((1u << kSdramAddressBits) - 1);
    next = address + bytes;
    return address;
  }
  std::optional<typename Types::Read> read() {
    if (stopped_ || below(100) >= reads_.busy) return std::nullopt;
    const unsigned most = 32 / PortBytes;
    const unsigned beats = 1u << below(most == 4 ? 3 : most);
    return typename Types::Read{id_++ & 0x3ff, place(reads_, next_read_, beats * PortBytes),
                                beats - 1};
  }
  std::optional<typename Types::Write> write() {
    if (stopped_ || below(100) >= writes_.busy) return std::nullopt;
    typename Types::Write w;
    w.address = place(writes_, next_write_, PortBytes);
    for (auto& half : w.data) half = static_cast<std::uint16_t>(random_());
    const std::uint32_t all = (1u << Types::kHalves) - 1;
    w.mask = mask_ == 0   ? all
             : mask_ == 1 ? 1u << below(Types::kHalves)
                          : static_cast<std::uint32_t>(random_()) & all;
    return w;
  }

  std::mt19937 random_;
  bool stopped_ = false;
  unsigned left_ = 0;
  SdramMood reads_, writes_;
  unsigned beats_ = 100;
  bool near_ = false;
  unsigned mask_ = 0;
  std::uint32_t next_read_ = 0;
  std::uint32_t next_write_ = 0;
  std::uint32_t id_ = 0;
};

}  // namespace dynrt::verif
