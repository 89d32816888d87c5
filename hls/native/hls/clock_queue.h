// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The times of the tokens of a FIFO; the tokens themselves lie in a Fifo<T>. Behind the FIFO there
// may be a buffer (rtl/lib/hls_buffer.v), to which a token moves as soon as one of its places is
// free. When it does so follows from the times before, so that nobody has to look at every clock.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace hls {

/// A clock that never comes.
inline constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

class ClockQueue {
 public:
  static constexpr unsigned kBufferPlaces = 2;

  /// A writer may send while fewer than `room` tokens wait in the FIFO; 0: always.
  explicit ClockQueue(unsigned room = 0) : room_(room) {}
  /// Of an empty queue.
  void put_buffer_behind() { buffered_ = true; }

  bool empty() const { return head_ == tail_; }
  /// The clock from which the first token can be taken; kNever without one.
  std::uint64_t front() const { return front_; }
  bool offers(std::uint64_t now) const { return front_ <= now; }
  /// The clocks in which the first token, taken in clock `now`, was in the FIFO.
  std::pair<std::uint64_t, std::uint64_t> stay(std::uint64_t now) const {
    return {ready_[head_ & mask_], buffered_ ? leaves_[head_ & mask_] : now};
  }
  /// The state at the clock's beginning: a place that becomes free in a clock can be used in the
  /// next.
  bool has_room(std::uint64_t now) { return room_ == 0 || waiting(now) < room_; }
  /// Where there is no room: the clock in which there will be; kNever if that depends on the
  /// reader.
  std::uint64_t has_room_from(std::uint64_t now) const {
    if (!buffered_) return taken_at_ == now ? now + 1 : kNever;
    return left_ < leaving() ? leaves_[left_ & mask_] + 1 : kNever;
  }

  /// A token that the writer sends, with the clock in which it comes to the head of an empty FIFO;
  /// not before the one ahead of it.
  void push(std::uint64_t ready) {
    if (tail_ - head_ > mask_) grow();
    ready_[tail_++ & mask_] = ready;
    if (buffered_) {
      if (tail_ - head_ <= kBufferPlaces) leave(tail_ - 1, ready);
    } else if (tail_ - head_ == 1) {
      front_ = ready;
    }
  }
  void pop(std::uint64_t now) {
    ++head_;
    taken_at_ = now;
    if (buffered_) {
      if (tail_ - head_ >= kBufferPlaces) leave(head_ + kBufferPlaces - 1, now + 1);
      front_ = empty() ? kNever : leaves_[head_ & mask_] + 1;
    } else {
      front_ = empty() ? kNever : ready_[head_ & mask_];
    }
  }

 private:
  /// Tokens in the FIFO.
  std::size_t waiting(std::uint64_t now) {
    arrived_ = std::max(arrived_, head_);
    while (arrived_ != tail_ && ready_[arrived_ & mask_] <= now) ++arrived_;
    if (!buffered_) return arrived_ - head_ + (taken_at_ == now ? 1 : 0);
    left_ = std::max(left_, head_);
    while (left_ < leaving() && leaves_[left_ & mask_] < now) ++left_;
    return arrived_ - left_;
  }
  /// The first token that does not know yet when it leaves for the buffer.
  std::size_t leaving() const { return std::min(tail_, head_ + kBufferPlaces); }
  /// A token leaves for a buffer that has a free place from clock `from` on.
  void leave(std::size_t token, std::uint64_t from) {
    last_leaves_ = std::max({ready_[token & mask_], last_leaves_ + 1, from});
    leaves_[token & mask_] = last_leaves_;
    if (token == head_) front_ = last_leaves_ + 1;
  }
  void grow() {
    const std::size_t mask = 2 * mask_ + 1;
    for (std::vector<std::uint64_t>* ring : {&ready_, &leaves_}) {
      std::vector<std::uint64_t> wider(mask + 1);
      for (std::size_t i = head_; i != tail_; ++i) wider[i & mask] = (*ring)[i & mask_];
      *ring = std::move(wider);
    }
    mask_ = mask;
  }

  unsigned room_;
  bool buffered_ = false;
  std::uint64_t front_ = kNever;
  std::uint64_t taken_at_ = kNever;
  std::uint64_t last_leaves_ = kNever;  ///< no token left before clock 0
  std::size_t head_ = 0;                ///< of all tokens ever pushed, the first that waits
  std::size_t left_ = 0;     ///< the first that was still in the FIFO when somebody asked for room
  std::size_t arrived_ = 0;  ///< the first that was not ready then
  std::size_t tail_ = 0;
  std::size_t mask_ = 7;  ///< the places of the rings less one, which are a power of two
  std::vector<std::uint64_t> ready_ = std::vector<std::uint64_t>(mask_ + 1);
  std::vector<std::uint64_t> leaves_ = std::vector<std::uint64_t>(mask_ + 1);  ///< for the buffer
};

}  // namespace hls
