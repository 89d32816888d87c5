// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The queues that channels are made of in the native model, and the ends of a channel. What moves
// tokens without looking at them (join.h) knows TokenQueue, InEnd and OutEnd, so that it is
// compiled once and not for every type of token.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "hls/fields.h"

namespace hls {

template <class T>
class In;
template <class T>
class Out;

/// A queue of tokens of some type.
class TokenQueue {
 public:
  TokenQueue() = default;
  TokenQueue(const TokenQueue&) = delete;
  TokenQueue& operator=(const TokenQueue&) = delete;
  virtual ~TokenQueue() = default;
  /// Tokens ever pushed.
  std::uint64_t pushed() const { return pushed_; }
  virtual bool has_tokens() const = 0;
  /// Takes the first token and pushes it into all of `to`, which hold tokens of the same type.
  virtual void move_to(const std::vector<std::shared_ptr<TokenQueue>>& to) = 0;

 protected:
  std::uint64_t pushed_ = 0;
};

/// The memory of a queue: bytes between `head` and `tail` wait. A unit mostly drains its queue, so
/// the tokens lie in one array and move to its beginning when they reach its end.
class QueueMemory : public TokenQueue {
 protected:
  explicit QueueMemory(std::size_t room)
      : room_(room), row_(std::make_unique_for_overwrite<std::byte[]>(room)) {}
  /// Makes room for one more token at `tail`.
  void make_room();
  std::size_t room_;  ///< bytes
  std::unique_ptr<std::byte[]> row_;
  std::byte* head_ = row_.get();  ///< the token to pop next
  std::byte* tail_ = head_;       ///< where to push the next
  std::byte* end_ = head_ + room_;
};

inline void QueueMemory::make_room() {
  const auto waiting = static_cast<std::size_t>(tail_ - head_);
  if (2 * waiting <= room_) {
    std::memmove(row_.get(), head_, waiting);
  } else {
    room_ *= 2;
    auto wider = std::make_unique_for_overwrite<std::byte[]>(room_);
    std::memcpy(wider.get(), head_, waiting);
    row_ = std::move(wider);
  }
  head_ = row_.get();
  tail_ = head_ + waiting;
  end_ = head_ + room_;
}

/// An unbounded first-in first-out queue of tokens; the join bounds it in hardware.
template <class T>
class Fifo final : public QueueMemory {
 public:
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t),
                "a token is bits");
  Fifo() : QueueMemory(64 * sizeof(T)) {}
  bool empty() const { return head_ == tail_; }
  std::size_t size() const { return static_cast<std::size_t>(tail_ - head_) / sizeof(T); }
  bool has_tokens() const override { return !empty(); }
  void push(const T& token) {
    if (tail_ == end_) make_room();
    copy_leaves(*reinterpret_cast<T*>(tail_), token);
    tail_ += sizeof(T);
    ++pushed_;
  }
  const T& front() const {
    assert(!empty());
    return *reinterpret_cast<const T*>(head_);
  }
  T pop() {
    const T& token = front();
    head_ += sizeof(T);
    return token;
  }
  void move_to(const std::vector<std::shared_ptr<TokenQueue>>& to) override {
    const T& token = front();
    head_ += sizeof(T);
    for (const auto& queue : to) static_cast<Fifo&>(*queue).push(token);
  }
};

/// What a join knows of the tokens of a channel.
struct TokenType {
  unsigned width;  ///< bits
  std::unique_ptr<TokenQueue> (*make_queue)();
};
template <class T>
constexpr TokenType token_type() {
  return {bit_width_of<T>(), [] { return std::unique_ptr<TokenQueue>(new Fifo<T>); }};
}

/// The reading end of a channel, of whichever type: an In<T>.
class InEnd {
 public:
  bool bound() const { return tokens_ != nullptr; }
  const std::shared_ptr<TokenQueue>& tokens() const { return tokens_; }
  /// `queue` holds tokens of this end's type.
  void bind_tokens(std::shared_ptr<TokenQueue> queue) { tokens_ = std::move(queue); }

 private:
  std::shared_ptr<TokenQueue> tokens_;
};

/// The writing end of a channel, of whichever type: an Out<T>. It writes into every queue that it
/// is bound to.
class OutEnd {
 public:
  const std::vector<std::shared_ptr<TokenQueue>>& tokens() const { return tokens_; }
  /// `queue` holds tokens of this end's type.
  void bind_tokens(std::shared_ptr<TokenQueue> queue) { tokens_.push_back(std::move(queue)); }

 private:
  std::vector<std::shared_ptr<TokenQueue>> tokens_;
};

/// The FIFO of a writer, if its channel has a bound.
enum class WriterFifo : std::uint8_t {
  kHoldsAll,  ///< never refuses a token
  kShort,     ///< refuses tokens when full, so that the writer waits
};

/// The writing ends of one channel, all of the same type.
template <class T>
class Writers {
 public:
  Writers(std::initializer_list<Out<T>*> ends) {
    for (Out<T>* end : ends) push_back(end);
  }
  Writers(Out<T>* end, WriterFifo fifo) { push_back(end, fifo); }
  void push_back(Out<T>* end, WriterFifo fifo = WriterFifo::kHoldsAll) {
    ends_.push_back(end);
    if (fifo == WriterFifo::kShort) short_fifos_.push_back(end);
  }
  const std::vector<OutEnd*>& ends() const { return ends_; }
  /// Those of them whose FIFOs are short.
  const std::vector<OutEnd*>& short_fifos() const { return short_fifos_; }

 private:
  std::vector<OutEnd*> ends_, short_fifos_;
};
/// The reading ends of one channel.
template <class T>
class Readers {
 public:
  Readers(std::initializer_list<In<T>*> ends) {
    for (In<T>* end : ends) ends_.push_back(end);
  }
  void push_back(In<T>* end) { ends_.push_back(end); }
  const std::vector<InEnd*>& ends() const { return ends_; }

 private:
  std::vector<InEnd*> ends_;
};

}  // namespace hls
