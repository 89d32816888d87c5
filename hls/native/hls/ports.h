// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The members that a unit is made of, as the native model has them: channels are queues, RAMs are
// arrays. hls/lowered/hls/ports.h has the same names for hlsc; only the include path decides which
// of the two a translation unit sees. A unit lists its ports once with HLS_PORTS.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "hls/fields.h"
#include "hls/port_kind.h"

/// Names all ports of a unit (channels, RAM ports, configuration), and gives hlsc the file that the
/// unit is in.
#define HLS_PORTS(...)    \
  HLS_FIELDS(__VA_ARGS__) \
  static constexpr std::string_view hls_file() { return __FILE__; }

namespace hls {

/// An unbounded first-in first-out queue of tokens; the join bounds it in hardware. A unit mostly
/// drains it, so the tokens lie in one array and move to its beginning when they reach its end.
template <class T>
class Fifo {
 public:
  bool empty() const { return head_ == tail_; }
  std::size_t size() const { return static_cast<std::size_t>(tail_ - head_); }
  /// Tokens ever pushed.
  std::uint64_t pushed() const { return moved_ + static_cast<std::uint64_t>(tail_ - row_.get()); }
  void push(const T& token) {
    if (tail_ == end_) make_room();
    copy_leaves(*tail_++, token);
  }
  T pop() {
    assert(!empty());
    return *head_++;
  }

 private:
  [[gnu::noinline]] void make_room() {
    const std::size_t waiting = size();
    moved_ = pushed() - waiting;
    if (2 * waiting <= room_) {
      std::move(head_, tail_, row_.get());
    } else {
      room_ *= 2;
      auto wider = std::make_unique<T[]>(room_);
      std::move(head_, tail_, wider.get());
      row_ = std::move(wider);
    }
    head_ = row_.get();
    tail_ = head_ + waiting;
    end_ = head_ + room_;
  }
  std::size_t room_ = 64;
  std::unique_ptr<T[]> row_ = std::make_unique<T[]>(room_);
  T* head_ = row_.get();  ///< the token to pop next
  T* tail_ = head_;       ///< where to push the next
  T* end_ = head_ + room_;
  std::uint64_t moved_ = 0;  ///< tokens pushed and popped before the row's first
};

/// A channel's reading end. A transaction reads one token from every In of its unit.
template <class T>
class In {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kIn, bit_width_of<T>()};
  T read() { return queue_->pop(); }
  /// Tokens that wait to be read.
  std::size_t ready() const { return queue_ ? queue_->size() : 0; }
  void bind(std::shared_ptr<Fifo<T>> queue) { queue_ = std::move(queue); }
  const std::shared_ptr<Fifo<T>>& queue() const { return queue_; }

 private:
  std::shared_ptr<Fifo<T>> queue_;
};

/// A channel's writing end; bound to several queues it is a fork, and an arbiter merges several
/// Outs that share a queue. A transaction writes at most one token, under any condition.
template <class T>
class Out {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kOut, bit_width_of<T>()};
  void write(const T& token) {
    for (auto& queue : queues_) queue->push(token);
  }
  void bind(std::shared_ptr<Fifo<T>> queue) { queues_.push_back(std::move(queue)); }
  bool bound() const { return !queues_.empty(); }

 private:
  std::vector<std::shared_ptr<Fifo<T>>> queues_;
};

/// A synchronous RAM of N rows with one read and one write port: a read and a write per
/// transaction.
template <class T, unsigned N, Hazard H = Hazard::kExclusive>
class Ram1R1W {
 public:
  using Address = uint<index_width(N)>;
  T read(Address address) const { return rows_[address.to_u64()]; }
  void write(Address address, const T& row) { rows_[address.to_u64()] = row; }
  void clear() { rows_.assign(N, T{}); }

 private:
  std::vector<T> rows_ = std::vector<T>(N);
};

/// A RAM small enough for LUTs, read and written in one stage, so that consecutive transactions on
/// one row see each other. Its rows start as zeros; those of other RAMs as whatever lies there.
template <class T, unsigned N>
class RegisterFile : public Ram1R1W<T, N> {};

/// The two ends of a RAM that one unit writes and others read. The join gives every reader its own
/// copy. Latency is the clocks from address to data: 1 for a RAM on the chip, more for a bank off
/// it.
template <class T, unsigned N>
class RamWrite {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kRamWrite, bit_width_of<T>(), N};
  using Address = uint<index_width(N)>;
  /// A row's number and the row written there.
  using Log = std::vector<std::pair<std::uint64_t, T>>;
  void write(Address address, const T& row) {
    if (rows_) (*rows_)[address.to_u64()] = row;
    if (log_) log_->emplace_back(address.to_u64(), row);
    if (taker_) taker_(address.to_u64(), row);
  }
  void bind(std::shared_ptr<std::vector<T>> rows) { rows_ = std::move(rows); }
  /// Gives every row with its number to `taker`.
  void bind(std::function<void(std::uint64_t, const T&)> taker) { taker_ = std::move(taker); }
  /// Appends every write to `log` from now on, for tests that compare them one by one.
  void record(Log* log) { log_ = log; }

 private:
  std::shared_ptr<std::vector<T>> rows_;
  std::function<void(std::uint64_t, const T&)> taker_;
  Log* log_ = nullptr;
};
template <class T, unsigned N, unsigned Latency = 1>
class RamRead {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kRamRead, bit_width_of<T>(), N, Latency};
  using Address = uint<index_width(N)>;
  T read(Address address) const { return (*rows_)[address.to_u64()]; }
  void bind(std::shared_ptr<std::vector<T>> rows) { rows_ = std::move(rows); }

 private:
  std::shared_ptr<std::vector<T>> rows_;
};

/// A value that the host sets between frames and that does not change during a frame.
template <class T>
class Config {
 public:
  using Data = T;
  static constexpr PortInfo kPort{PortKind::kConfig, bit_width_of<T>()};
  T get() const { return *value_; }
  void bind(std::shared_ptr<T> value) { value_ = std::move(value); }

 private:
  std::shared_ptr<T> value_;
};

/// Replaces a port that a configuration leaves out.
struct Absent {};
template <bool Present, class Port>
using PortIf = std::conditional_t<Present, Port, Absent>;

}  // namespace hls
