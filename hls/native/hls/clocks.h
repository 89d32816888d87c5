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

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
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
    bool has_room(std::uint64_t now) const {
      if (room == 0) return true;
      std::size_t waiting = taken_at == now ? 1 : 0;
      for (auto at = ready.begin(); at != ready.end() && *at <= now; ++at) ++waiting;
      return waiting < room;
    }
  };

  /// Moves the token at the head of a queue to its reader; false: the queue still needs it.
  using Move = std::function<bool()>;
  struct Feed {
    Queue* queue;
    Move move;
  };

  /// `run` makes a transaction for every token at the unit's inputs.
  void unit(const std::string& name, const ModuleSchedule& schedule, std::function<void()> run) {
    units_.push_back({.name = name, .schedule = schedule, .run = std::move(run)});
  }
  /// Of an output of unit `name`.
  Queue* output(const std::string& name, std::function<std::uint64_t()> pushed, bool bounded) {
    Unit& unit = find(name);
    queues_.push_back({.pushed = std::move(pushed), .room = bounded ? 0 : unit.schedule.room});
    unit.outputs.push_back(&queues_.back());
    return &queues_.back();
  }
  /// A queue of tokens from outside.
  Queue* input() { return &queues_.emplace_back(); }

  /// Queues that an arbiter merges before an input of unit `name`.
  void feed(const std::string& name, std::vector<Feed> feeds) {
    find(name).sources.push_back({.feeds = std::move(feeds)});
  }
  /// The same before a fork to inputs of `readers`, each the only one of its unit, and to queues of
  /// `depth` tokens; move() moves a token to all of them.
  std::vector<Queue*> fork(std::vector<Feed> feeds, const std::vector<std::string>& readers,
                           std::size_t queues, unsigned depth) {
    Fork fork{.source = {.feeds = std::move(feeds)}};
    for (const std::string& name : readers) {
      fork.readers.push_back(&find(name));
      find(name).waits_for_fork = true;
    }
    for (std::size_t i = 0; i < queues; ++i) {
      fork.branches.push_back(&queues_.emplace_back(Queue{.room = depth}));
    }
    forks_.push_back(std::move(fork));
    return forks_.back().branches;
  }
  /// Takes every token.
  void sink(Feed feed) { sinks_.push_back({.feeds = {std::move(feed)}}); }

  /// A RAM whose rows may be read and written at the same time. `logged` writes wait until `land`
  /// shows each of them to the readers in stage `read_stage`.
  void stale_ram(const std::string& writer, const std::string& port, unsigned read_stage,
                 std::function<std::uint64_t()> logged, std::function<void()> land) {
    Unit& unit = find(writer);
    const auto stage = unit.schedule.ram_stages.find(port);
    if (stage == unit.schedule.ram_stages.end()) {
      throw std::invalid_argument("the schedule of unit '" + writer + "' does not say in which " +
                                  "stage it writes '" + port + "'");
    }
    const unsigned written = stage->second + 1;
    rams_.push_back({.after = written > read_stage ? written - read_stage : 0,
                     .logged = std::move(logged),
                     .land = std::move(land)});
    unit.rams.push_back(&rams_.back());
  }

  /// Runs until no token moves any more.
  void run() {
    for (std::uint64_t now = next(0); now != kNever;) now = tick(now) ? now + 1 : next(now + 1);
  }

  /// Clocks in which unit `name` had its tokens but an output no room.
  std::uint64_t stalls(const std::string& name) { return find(name).stalls; }

 private:
  /// The round-robin arbiter of rtl/lib/hls_arbiter.v; with one queue there is no arbiter.
  struct Source {
    std::vector<Feed> feeds;
    std::uint32_t after = 0;  ///< the queues after the one that sent last
    int offered = -1;         ///< the queue whose token waits for its reader

    int choice(std::uint64_t now) const {
      if (offered >= 0) return offered;
      int first = -1;
      for (int i = 0; i < static_cast<int>(feeds.size()); ++i) {
        if (!feeds[static_cast<std::size_t>(i)].queue->offers(now)) continue;
        if (after >> i & 1) return i;
        if (first < 0) first = i;
      }
      return first;
    }
    void take(std::uint64_t now, int chosen) {
      Feed& feed = feeds[static_cast<std::size_t>(chosen)];
      if (!feed.move()) {
        offered = chosen;
        return;
      }
      feed.queue->ready.pop_front();
      feed.queue->taken_at = now;
      offered = -1;
      after = ~1u << chosen;
    }
  };
  struct Ram {
    unsigned after;  ///< clocks from the writing transaction's start to the first that sees the row
    std::function<std::uint64_t()> logged;
    std::function<void()> land;
    std::deque<std::uint64_t> due = {};
  };
  struct Unit {
    std::string name;
    ModuleSchedule schedule;
    std::function<void()> run;
    std::vector<Source> sources = {};
    std::vector<Queue*> outputs = {};
    std::vector<Ram*> rams = {};
    bool waits_for_fork = false;       ///< a fork brings its tokens
    std::uint64_t forked_at = kNever;  ///< when it brought the last
    std::uint64_t stalls = 0;

    bool has_room(std::uint64_t now) const {
      return std::ranges::all_of(outputs, [now](const Queue* q) { return q->has_room(now); });
    }
  };
  struct Fork {
    Source source;
    std::vector<Unit*> readers = {};
    std::vector<Queue*> branches = {};
  };

  Unit& find(const std::string& name) {
    const auto found = std::ranges::find(units_, name, &Unit::name);
    if (found == units_.end()) throw std::logic_error("no unit has the name " + name);
    return *found;
  }

  bool tick(std::uint64_t now) {
    bool moved = false;
    for (Ram& ram : rams_) {
      for (; !ram.due.empty() && ram.due.front() <= now; ram.due.pop_front()) ram.land();
    }
    for (Source& sink : sinks_) {
      if (sink.feeds[0].queue->offers(now)) {
        sink.take(now, 0);
        moved = true;
      }
    }
    for (Fork& fork : forks_) moved |= pass(fork, now);
    for (Unit& unit : units_) moved |= fire(unit, now);
    return moved;
  }
  static bool pass(Fork& fork, std::uint64_t now) {
    const int chosen = fork.source.choice(now);
    if (chosen < 0) return false;
    const bool ready =
        std::ranges::all_of(fork.readers, [now](const Unit* u) { return u->has_room(now); }) &&
        std::ranges::all_of(fork.branches, [now](const Queue* q) { return q->has_room(now); });
    if (!ready) {
      fork.source.offered = chosen;
      return false;
    }
    fork.source.take(now, chosen);
    for (Unit* reader : fork.readers) reader->forked_at = now;
    for (Queue* branch : fork.branches) branch->ready.push_back(now + 1);
    return true;
  }
  static bool fire(Unit& unit, std::uint64_t now) {
    if (unit.waits_for_fork) {
      if (unit.forked_at != now) return false;
    } else {
      bool tokens = true;
      for (Source& source : unit.sources) tokens &= source.choice(now) >= 0;
      const bool room = unit.has_room(now);
      if (!tokens || !room) {
        unit.stalls += tokens;
        for (Source& source : unit.sources) source.offered = source.choice(now);
        return false;
      }
      for (Source& source : unit.sources) source.take(now, source.choice(now));
    }
    unit.run();
    for (Queue* queue : unit.outputs) {
      for (const std::uint64_t pushed = queue->pushed(); queue->sent < pushed; ++queue->sent) {
        queue->ready.push_back(now + unit.schedule.stages);
      }
    }
    for (Ram* ram : unit.rams) {
      while (ram->due.size() < ram->logged()) ram->due.push_back(now + ram->after);
    }
    return true;
  }
  /// The first clock from `now` on in which a token can be taken that could not before.
  std::uint64_t next(std::uint64_t now) const {
    std::uint64_t soonest = kNever;
    for (const Queue& queue : queues_) {
      if (!queue.ready.empty() && queue.ready.front() >= now) {
        soonest = std::min(soonest, queue.ready.front());
      }
    }
    return soonest;
  }

  std::deque<Unit> units_;
  std::deque<Queue> queues_;
  std::deque<Ram> rams_;
  std::vector<Fork> forks_;
  std::vector<Source> sinks_;
};

}  // namespace hls
