// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs the native units in the order and at the clocks of their Verilog. hlsc's schedules and the
// modules of rtl/lib decide when a transaction starts, when a token can be taken and which input an
// arbiter chooses. The units compute as always; this file adds only time. One tick() is one clock:
// a unit with all its tokens, and room for its results, takes the tokens and works, and its results
// come to the heads of their FIFOs as many clocks later as the unit has stages.
//
// Two things equal the Verilog only on a condition. RAMs within a unit, and exclusive RAMs between
// units, are read and written at a transaction's start; the promise of exclusive access makes this
// the same. And the outside takes and gives tokens in every clock in which there are any.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "hls/module_schedule.h"

namespace hls {

class Clocks {
 public:
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  /// The times of the tokens of a FIFO; the tokens themselves lie in a Fifo<T>.
  struct Queue {
    std::function<std::uint64_t()> pushed = {};  ///< tokens ever sent
    unsigned room = 0;                           ///< a unit may send while fewer wait; 0: always
    std::uint64_t sent = 0;
    std::deque<std::uint64_t> ready = {};  ///< the clock from which each can be taken
    std::uint64_t taken_at = kNever;

    bool offers(std::uint64_t now) const { return !ready.empty() && ready.front() <= now; }
    /// The state at the clock's beginning: a place that becomes free in a clock can be used in the
    /// next.
    bool has_room(std::uint64_t now) const;
  };

  /// Moves the token at the head of a queue to its reader; false: the queue still needs it.
  using Move = std::function<bool()>;
  struct Feed {
    Queue* queue;
    Move move;

    /// Takes the token at the head.
    void take(std::uint64_t now) const;
  };

  /// `run` makes a transaction for every token at the unit's inputs.
  void unit(const std::string& name, const ModuleSchedule& schedule, std::function<void()> run);
  /// Of an output of unit `name`.
  Queue* output(const std::string& name, std::function<std::uint64_t()> pushed, bool bounded);
  /// A queue of tokens from outside.
  Queue* input() { return &queues_.emplace_back(); }

  /// The queue before an input of unit `name`.
  void feed(const std::string& name, Feed feed);
  /// The buffer behind `feeds`, whose move() moves a token to it; several share it by an arbiter.
  Queue* merge(std::vector<Feed> feeds);
  /// The queue before a fork to inputs of `readers`, each the only one of its unit, and to queues
  /// of `depth` tokens; move() moves a token to all of them.
  std::vector<Queue*> fork(Feed feed, const std::vector<std::string>& readers, std::size_t queues,
                           unsigned depth);
  /// Takes every token.
  void sink(Feed feed);

  /// A RAM whose rows may be read in the clock that writes them. `logged` writes wait until `land`
  /// shows each of them to the readers in stage `read_stage`; in the clock before, `tear` marks the
  /// row of one, counted from the first that waits.
  void torn_ram(const std::string& writer, const std::string& port, unsigned read_stage,
                std::function<std::uint64_t()> logged, std::function<void(std::size_t)> tear,
                std::function<void()> land);

  /// Runs until no token moves any more.
  void run();

  /// Clocks in which unit `name` had its tokens but an output no room.
  std::uint64_t stalls(const std::string& name) { return find(name).stalls; }

 private:
  /// The round-robin arbiter of rtl/lib/hls_arbiter.v, with an hls_buffer.v behind it.
  struct Arbiter {
    std::vector<Feed> feeds;
    Queue* buffer;
    std::size_t granted = 0;  ///< the queue that may send
  };
  struct Ram {
    unsigned after;  ///< clocks from the writing transaction's start to the first that sees the row
    std::function<std::uint64_t()> logged;
    std::function<void(std::size_t)> tear;
    std::function<void()> land;
    std::deque<std::uint64_t> due = {};

    void land_until(std::uint64_t now);
    /// Of the rows that are written in this clock.
    void tear_at(std::uint64_t now) const;
  };
  struct Unit {
    std::string name;
    ModuleSchedule schedule;
    std::function<void()> run;
    std::vector<Feed> feeds = {};
    std::vector<Queue*> outputs = {};
    std::vector<Ram*> rams = {};
    bool waits_for_fork = false;       ///< a fork brings its tokens
    std::uint64_t forked_at = kNever;  ///< when it brought the last
    std::uint64_t stalls = 0;

    bool has_room(std::uint64_t now) const;
  };
  struct Fork {
    Feed feed;
    std::vector<Unit*> readers = {};
    std::vector<Queue*> branches = {};
  };

  Unit& find(const std::string& name);

  bool tick(std::uint64_t now);
  static bool arbitrate(Arbiter& arbiter, std::uint64_t now);
  static bool pass(Fork& fork, std::uint64_t now);
  static bool fire(Unit& unit, std::uint64_t now);
  /// The first clock from `now` on in which a token can be taken that could not before.
  std::uint64_t next(std::uint64_t now) const;

  std::deque<Unit> units_;
  std::deque<Queue> queues_;
  std::deque<Ram> rams_;
  std::vector<Arbiter> arbiters_;
  std::vector<Fork> forks_;
  std::vector<Feed> sinks_;
};

}  // namespace hls
