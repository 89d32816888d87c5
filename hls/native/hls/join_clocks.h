// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A join's connections with clocks (clocks.h): every Out has a queue of its own, from which a token
// is moved to the In in the clock in which its transaction starts.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hls/clocks.h"
#include "hls/fifo.h"
#include "hls/join_ports.h"

namespace hls {

/// Sends the job at the head of `jobs` to `numbered` with a number; true, and the job is gone, if
/// that was its last.
using SendNumbered = bool (*)(TokenQueue& jobs, std::uint64_t number, TokenQueue& numbered);

/// A RAM whose rows may be read in the clock that writes them (a read-write collision).
struct TornRam {
  const void* writer;                     ///< its port
  const void* reader;                     ///< its port
  std::function<std::uint64_t()> logged;  ///< the number of pending writes
  std::function<void(std::size_t)> tear;  ///< marks the row of the i-th pending write as torn
  std::function<void()> land;             ///< shows the first pending write to the reader
};

class JoinClocks {
 public:
  using Tokens = std::shared_ptr<TokenQueue>;

  explicit JoinClocks(ModuleSchedules schedules) : schedules_(std::move(schedules)) {}

  /// Throws std::invalid_argument where the module has no schedule.
  void unit(const std::string& name, const std::string& module, std::function<void()> run);
  /// One channel from any of `from` to all of `to`; a lone reader's queue is replaced by the one
  /// that its tokens come from.
  void channel(const std::string& name, const JoinPorts& ports, const std::vector<OutEnd*>& from,
               const std::vector<InEnd*>& to, TokenType type, unsigned depth,
               const std::vector<OutEnd*>& short_fifos);
  /// `sent` counts the jobs that were sent for the first time.
  void repeat(const std::string& name, const JoinPorts& ports, const std::vector<OutEnd*>& from,
              const InEnd& to, TokenType type, SendNumbered send,
              std::shared_ptr<std::uint64_t> sent, unsigned depth,
              const std::vector<OutEnd*>& short_fifos);
  void torn_ram(const JoinPorts& ports, TornRam ram);
  /// The outside writes into the queue of `to`.
  void input(const JoinPorts& ports, const std::string& name, const InEnd& to);
  void output(const JoinPorts& ports, const std::string& name, OutEnd& from, const Tokens& queue);
  void sink(const std::string& name, const JoinPorts& ports, OutEnd& from, const Tokens& queue);
  /// Between outputs and an input of these names; `writes` may be empty.
  void attach(const std::string& requests, const std::string& answers, const std::string& writes,
              Device& device) {
    clocks_.device(ends_.at(requests), ends_.at(answers),
                   writes.empty() ? nullptr : ends_.at(writes), device);
  }

  void arrives(const std::string& input, std::uint64_t clock) { ends_.at(input)->push(clock); }
  void run() { clocks_.run(); }
  void watch(ClockWatch& watch) { clocks_.watch(watch); }
  /// As the watch numbers them.
  const std::vector<FifoRecord>& fifos() const { return fifos_; }
  std::uint64_t now() const { return clocks_.now(); }
  std::uint64_t first_of(const std::string& output) const;
  std::uint64_t stalls(const std::string& unit) { return clocks_.stalls(unit); }

 private:
  /// Where a channel's tokens come from.
  struct Source {
    Clocks::Queue* queue;
    Tokens tokens;
  };
  /// All of `from`, with an arbiter and a buffer where there are several.
  Source merge(const std::string& name, const JoinPorts& ports, const std::vector<OutEnd*>& from,
               TokenType type, unsigned depth, const std::vector<OutEnd*>& short_fifos);
  Clocks::Queue* output(const std::string& name, const JoinPorts& ports, OutEnd& out,
                        const Tokens& queue, unsigned depth);
  /// Gives the queue.
  Clocks::Queue* add_fifo(Clocks::Queue* queue, FifoRecord record);

  ModuleSchedules schedules_;
  Clocks clocks_;
  std::map<std::string, std::string> modules_;  ///< by unit
  std::map<std::string, Clocks::Queue*> ends_;  ///< inputs and outputs, by channel
  std::vector<FifoRecord> fifos_;
};

}  // namespace hls
