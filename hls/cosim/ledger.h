// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The transactions of a co-simulated unit that are under way, and the packets that they hold. A
// transaction is over when its inputs were taken and everything that it writes to the outside was
// seen. One that writes nothing is over when a later one was seen, or after `drain` clocks in which
// no output was held up.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>

namespace hls::cosim {

class Ledger {
 public:
  Ledger(unsigned drain, unsigned return_clocks) : drain_(drain), return_clocks_(return_clocks) {}

  std::uint64_t begin(unsigned inputs, std::optional<std::uint64_t> packet) {
    open_.push_back({inputs, 0, false, packet, 0, std::nullopt});
    if (packet) ++busy_[*packet];
    return first_ + open_.size() - 1;
  }
  void expect(std::uint64_t transaction) {
    ++at(transaction).effects_left;
    at(transaction).any_effect = true;
  }
  void accepted(std::uint64_t transaction) {
    --at(transaction).inputs_left;
    at(transaction).accepted = free_clocks_;
  }
  void seen(std::uint64_t transaction) {
    --at(transaction).effects_left;
    if (transaction >= seen_below_) seen_below_ = transaction;
  }

  bool holds(std::uint64_t packet) const {
    const auto found = busy_.find(packet);
    return found != busy_.end() && found->second > 0;
  }
  bool idle() const { return open_.empty(); }
  std::uint64_t begun() const { return first_ + open_.size(); }

  /// Ends a clock; `free` if no output was held up in it.
  void tick(bool free) {
    ++clock_;
    if (free) ++free_clocks_;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      Transaction& t = open_[i];
      if (t.inputs_left > 0 || t.effects_left > 0) continue;
      const bool passed = first_ + i < seen_below_ || free_clocks_ - t.accepted >= drain_;
      if (!t.any_effect && !passed) continue;
      if (!t.over) t.over = clock_;
      // The packet cannot come back sooner than through a FIFO and another unit.
      if (t.packet && clock_ >= *t.over + return_clocks_) {
        --busy_[*t.packet];
        t.packet.reset();
      }
    }
    while (!open_.empty() && open_.front().over && !open_.front().packet) {
      open_.pop_front();
      ++first_;
    }
  }

 private:
  struct Transaction {
    unsigned inputs_left;
    unsigned effects_left;
    bool any_effect;
    std::optional<std::uint64_t> packet;
    std::uint64_t accepted;  ///< in free clocks
    std::optional<std::uint64_t> over;
  };
  Transaction& at(std::uint64_t transaction) { return open_[transaction - first_]; }

  unsigned drain_;
  unsigned return_clocks_;
  std::deque<Transaction> open_;
  std::uint64_t first_ = 0;
  std::uint64_t seen_below_ = 0;  ///< the latest transaction with a result that was seen
  std::uint64_t clock_ = 0;
  std::uint64_t free_clocks_ = 0;
  std::unordered_map<std::uint64_t, unsigned> busy_;
};

}  // namespace hls::cosim
