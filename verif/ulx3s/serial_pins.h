// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The host's end of a serial line, bit by bit in time: eight data bits, lowest first, no parity,
// one stop bit.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

namespace dynrt::host {

class SerialPins {
 public:
  explicit SerialPins(std::uint64_t bit_ps) : bit_ps_(bit_ps) {}

  void send(std::uint8_t byte) { to_send_.push_back(byte); }
  bool is_sending() const { return !to_send_.empty() || left_ > 0; }
  std::deque<std::uint8_t>& received() { return received_; }

  /// The level that the host drives at a time; times only grow.
  bool drive(std::uint64_t now) {
    while (now >= next_bit_ && is_sending()) begin_bit(now);
    return level_;
  }
  /// The level that the board drives at a time.
  void sample(std::uint64_t now, bool level) {
    if (!receives_) {
      if (level) return;
      receives_ = Byte{now + bit_ps_ * 3 / 2, 0, 0};
    }
    if (now < receives_->next) return;
    if (receives_->bits == kDataBits) {
      if (level) received_.push_back(receives_->data);  // else it has no stop bit
      receives_.reset();
      return;
    }
    receives_->data |= static_cast<std::uint8_t>(unsigned{level} << receives_->bits++);
    receives_->next += bit_ps_;
  }

 private:
  static constexpr unsigned kDataBits = 8;
  struct Byte {
    std::uint64_t next;  ///< time of the next sample, in the middle of a bit
    unsigned bits;
    std::uint8_t data;
  };

  void begin_bit(std::uint64_t now) {
    if (left_ == 0) {  // a start bit
      sends_ = to_send_.front() | 1u << kDataBits;
      to_send_.pop_front();
      left_ = kDataBits + 1;
      level_ = false;
    } else {
      level_ = (sends_ & 1) != 0;
      sends_ >>= 1;
      --left_;
    }
    // A line that was idle begins now, and one that was not is as fast as it can be.
    next_bit_ = (next_bit_ + bit_ps_ <= now ? now : next_bit_) + bit_ps_;
  }

  const std::uint64_t bit_ps_;
  std::deque<std::uint8_t> to_send_;
  unsigned sends_ = 0;
  unsigned left_ = 0;  ///< bits of the byte that follow
  bool level_ = true;
  std::uint64_t next_bit_ = 0;
  std::optional<Byte> receives_;
  std::deque<std::uint8_t> received_;
};

}  // namespace dynrt::host
