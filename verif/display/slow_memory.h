// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A memory behind a port, for the display's tests: it answers in order, late and with pauses, and
// each pixel of it has a colour of its own.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <random>

#include "units/picture_format.h"

namespace dynrt::verif {

/// A pixel's bits in the memory, and the display's colour of them.
template <class Pixel>
std::uint32_t bits_of(unsigned number) {
  return number * 2654435761u >> (32 - 8 * Pixel::kBytes);
}
template <class Pixel>
std::uint32_t colour_of(unsigned number) {
  return static_cast<std::uint32_t>(
      Pixel::colour(uint<8 * Pixel::kBytes>::from(bits_of<Pixel>(number))).to_u64());
}

/// How the memory behaves, in clocks.
struct Manners {
  unsigned latency = 10;  ///< from a read to its first beat, and up to as many more
  unsigned stalls = 4;    ///< one in so many clocks it takes no read, or gives no beat
  unsigned pause = 0;     ///< from time to time it gives nothing for so long
};

template <class Top, class Pixel, unsigned BeatBytes>
class SlowMemory {
 public:
  explicit SlowMemory(Top& top) : top_(top) {}

  /// After each edge of the clock.
  void clock() {
    ++now_;
    if (read_ready_ && read_valid_) {
      due_.push_back({address_, last_, now_ + manners.latency + random_() % manners.latency});
      EXPECT_EQ(address_ % kBurstBytes, 0u);
      EXPECT_GE(address_, kPixelsAt);
    }
    if (beat_valid_) {
      EXPECT_TRUE(beat_ready_);
      if (++beat_ > due_.front().last) {
        due_.pop_front();
        beat_ = 0;
      }
    }
    if (manners.pause != 0 && random_() % 50000 == 0) paused_until_ = now_ + manners.pause;
    read_valid_ = top_.read_valid_o != 0;
    read_ready_ = random_() % manners.stalls != 0 && now_ > paused_until_;
    address_ = top_.read_address_o;
    last_ = top_.read_last_o;
    beat_ready_ = top_.beat_ready_o != 0;
    beat_valid_ = !due_.empty() && due_.front().at <= now_ && random_() % manners.stalls != 0 &&
                  now_ > paused_until_;
    top_.read_ready_i = read_ready_;
    top_.beat_valid_i = beat_valid_;
    if (beat_valid_) give(due_.front().address + beat_ * BeatBytes, beat_ == due_.front().last);
  }

  Manners manners;

 private:
  struct Read {
    unsigned address;
    unsigned last;
    std::uint64_t at;  ///< of its first beat
  };

  void give(unsigned byte, bool last) {
    top_.beat_last_i = last;
    for (unsigned i = 0; i < BeatBytes; i += Pixel::kBytes) {
      const std::uint32_t bits = bits_of<Pixel>((byte + i - kPixelsAt) / Pixel::kBytes);
      if constexpr (BeatBytes > 8) {
        static_assert(Pixel::kBytes == 4);
        top_.beat_data_i[i / 4] = bits;
      } else {
        static_assert(BeatBytes == Pixel::kBytes);
        top_.beat_data_i = static_cast<std::uint16_t>(bits);
      }
    }
  }

  Top& top_;
  std::mt19937 random_{1};
  std::uint64_t now_ = 0;
  std::uint64_t paused_until_ = 0;
  std::deque<Read> due_;
  unsigned beat_ = 0;  ///< of the first
  // What the top saw and said since the last edge.
  bool read_valid_ = false, read_ready_ = false, beat_valid_ = false, beat_ready_ = false;
  unsigned address_ = 0, last_ = 0;
};

}  // namespace dynrt::verif
