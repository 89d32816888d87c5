// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs the native units in the order and at the clocks of their Verilog. hlsc's schedules and the
// modules of rtl/lib decide when a transaction starts, when a token can be taken and which input an
// arbiter chooses. The units compute as always; this file adds only time. In a clock a unit with
// all its tokens, and room for its results, takes the tokens and works, and its results come to the
// heads of their FIFOs as many clocks later as the unit has stages. Who waits for a token or for
// room is asked again only when that may have come.
//
// Two things equal the Verilog only on a condition. RAMs within a unit, and exclusive RAMs between
// units, are read and written at a transaction's start; the promise of exclusive access makes this
// the same. And the outside takes and gives tokens in every clock in which there are any.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hls/clock_queue.h"
#include "hls/clock_watch.h"
#include "hls/device.h"
#include "hls/fifo.h"
#include "hls/module_schedule.h"
#include "hls/timing_wheel.h"

namespace hls {

class Clocks {
  static constexpr auto kNobody = static_cast<std::size_t>(-1);

 public:
  /// The times of a FIFO's tokens, and the numbers of the actors at its ends.
  struct Queue : ClockQueue {
    explicit Queue(std::size_t n, unsigned room = 0) : ClockQueue(room), number(n) {}
    std::size_t number;  ///< in the order in which they were made
    std::size_t reader = kNobody;
    std::size_t waits_for_room = kNobody;
  };

  /// Moves the token at the head of a queue to its reader; false: the queue still needs it. Empty
  /// where the reader takes it itself.
  using Move = std::function<bool()>;
  struct Feed {
    Queue* queue;
    Move move = {};
  };

  /// `run` makes a transaction.
  void unit(const std::string& name, const ModuleSchedule& schedule, std::function<void()> run);
  /// Of an output of unit `name`, which writes to `tokens`.
  Queue* output(const std::string& name, std::shared_ptr<TokenQueue> tokens, bool bounded);
  /// A queue of tokens from outside.
  Queue* input() { return add_queue(); }

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
  /// Takes every request and gives answers, which it puts into their queue itself.
  void device(Queue* requests, Queue* answers, Queue* writes, Device& device);

  /// A RAM whose rows may be read in the clock that writes them, by unit `reader` in stage
  /// `read_stage`. `logged` is the number of pending writes, and `land` shows the first of them to
  /// the reader. In the clock before, `tear(i)` marks the row of the i-th pending write as torn: a
  /// read-write collision.
  void torn_ram(const std::string& writer, const std::string& port, const std::string& reader,
                unsigned read_stage, std::function<std::uint64_t()> logged,
                std::function<void(std::size_t)> tear, std::function<void()> land);

  /// `watch` sees the next run. Units have the numbers of the order in which they were added.
  void watch(ClockWatch& watch) { watch_ = &watch; }
  /// Runs until no token moves any more.
  void run();
  /// The clock of the transaction that a unit makes.
  std::uint64_t now() const { return now_; }

  /// Clocks in which unit `name` had its tokens but an output had no space.
  std::uint64_t stalls(const std::string& name) { return find(name).stalls; }

 private:
  /// The parts that have work in some clocks, in the order of their work within a clock: written
  /// rows become visible, sinks, devices, arbiters, forks, the marks of torn rows that their own
  /// writer reads, the units that write rows which may be torn for other readers, the marks of
  /// these rows, all other units.
  struct Actor {
    void (*act)(Clocks&, void* self, std::uint64_t now);
    void* self;
  };
  /// The round-robin arbiter of rtl/lib/hls_arbiter.v, with an hls_buffer.v behind it.
  struct Arbiter {
    std::size_t actor = 0;
    std::vector<Feed> feeds;
    Queue* buffer;
    std::size_t granted = 0;  ///< the queue that may send
  };
  struct Ram {
    std::size_t landing = 0, tearing = 0;  ///< actors
    bool own;                              ///< its writer reads it
    unsigned after;  ///< clocks from the writing transaction's start to the first that sees the row
    std::function<std::uint64_t()> logged;
    std::function<void(std::size_t)> tear;
    std::function<void()> land;
    std::deque<std::uint64_t> due = {};
  };
  /// The wait of a unit or a fork that is not yet reported to the watch.
  struct Waiting {
    std::uint64_t told = 0;       ///< the first clock that is not reported
    const Queue* full = nullptr;  ///< the queue without space since then; null: a token is missing
  };
  struct Output {
    Queue* queue;
    std::shared_ptr<TokenQueue> tokens;
    std::uint64_t sent = 0;
  };
  struct Unit {
    std::size_t actor = 0;
    std::size_t number;
    std::string name;
    ModuleSchedule schedule;
    std::function<void()> run;
    std::vector<Feed> feeds = {};
    std::vector<Output> outputs = {};
    std::vector<Queue*> refusing = {};  ///< those of the outputs that may have no space
    std::vector<Ram*> rams = {};        ///< that it writes and whose rows may be torn
    bool waits_for_fork = false;        ///< a fork brings its tokens, and wakes it when it does
    std::uint64_t stalled_from = kNever;
    std::uint64_t stalls = 0;
    Waiting waiting = {};
  };
  struct Fork {
    std::size_t actor = 0;
    Feed feed;
    std::vector<Unit*> readers = {};
    std::vector<Queue*> branches = {};
    Waiting waiting = {};
  };
  struct Sink {
    std::size_t actor = 0;
    Feed feed;
  };
  struct Outside {
    std::size_t actor = 0;
    Queue* requests;
    Queue* answers;
    Queue* writes;  ///< or none
    Device* device;
  };

  Unit& find(const std::string& name);
  Queue* add_queue(unsigned room = 0) { return &queues_.emplace_back(queues_.size(), room); }

  /// Numbers the actors, and wakes those that have tokens.
  void number_actors();
  template <auto kAct, class Self>
  std::size_t number(Self& self);

  void arbitrate(Arbiter& arbiter, std::uint64_t now);
  void pass(Fork& fork, std::uint64_t now);
  void fire(Unit& unit, std::uint64_t now);
  void drain(Sink& sink, std::uint64_t now);
  void serve(Outside& outside, std::uint64_t now);
  void land(Ram& ram, std::uint64_t now);
  void tear(Ram& ram, std::uint64_t now);

  /// Whether it can send; if not, actor number `waiting` is woken when there may be room.
  bool has_room(Queue& queue, std::size_t waiting, std::uint64_t now);
  /// The first that cannot send; null if all can.
  Queue* without_room(const std::vector<Queue*>& queues, std::size_t waiting, std::uint64_t now) {
    for (Queue* queue : queues) {
      if (!has_room(*queue, waiting, now)) return queue;
    }
    return nullptr;
  }

  /// A unit or fork starts a transaction, or cannot as a queue is full; tells the watch for what it
  /// has waited before.
  template <class Actor>
  void see(Actor& actor, Queue* full, std::uint64_t now);
  void tell(const Unit& unit, std::uint64_t now);
  void tell(const Fork& fork, std::uint64_t now);

  /// Takes the token at the head.
  void take(const Feed& feed, std::uint64_t now);
  void push(Queue& queue, std::uint64_t ready);

  std::deque<Unit> units_;
  std::deque<Queue> queues_;
  std::deque<Ram> rams_;
  std::deque<Arbiter> arbiters_;
  std::deque<Fork> forks_;
  std::deque<Sink> sinks_;
  std::deque<Outside> outsides_;
  std::vector<Actor> actors_;
  TimingWheel wheel_;
  ClockWatch* watch_ = nullptr;
  std::uint64_t now_ = 0;
};

}  // namespace hls
