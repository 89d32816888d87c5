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
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hls/clocks.h"
#include "hls/join_ports.h"
#include "hls/ports.h"

namespace hls {

/// Sends a repeated job with a number; true if that was its last.
template <class Job, class Numbered>
bool send_numbered(const Job& job, std::uint64_t number, Fifo<Numbered>& out) {
  Numbered numbered;
  numbered.job = job;
  numbered.index = decltype(numbered.index)::from(number);
  numbered.last = number == job.repeat.to_u64();
  out.push(numbered);
  return numbered.last;
}

class JoinClocks {
 public:
  template <class T>
  using Shared = std::shared_ptr<Fifo<T>>;

  explicit JoinClocks(ModuleSchedules schedules) : schedules_(std::move(schedules)) {}

  /// Throws std::invalid_argument where the module has no schedule.
  void unit(const std::string& name, const std::string& module, std::function<void()> run) {
    const auto found = schedules_.find(module);
    if (found == schedules_.end()) {
      throw std::invalid_argument("there is no schedule of module '" + module + "'");
    }
    modules_[name] = module;
    clocks_.unit(name, found->second, std::move(run));
  }

  /// One channel from any of `from` to all of `to`, whose queues are bound.
  template <class T>
  void channel(const JoinPorts& ports, const std::vector<Out<T>*>& from,
               const std::vector<In<T>*>& to, unsigned depth) {
    // A reader that waits for other tokens too has a queue of its own behind the fork.
    std::vector<Shared<T>> targets, waiting, behind;
    std::vector<std::string> readers, waiting_readers;
    for (In<T>* in : to) {
      const std::string unit = ports.unit_of(in);
      if (to.size() == 1 || ports.inputs_of(unit) == 1) {
        targets.push_back(in->queue());
        readers.push_back(unit);
      } else {
        targets.push_back(std::make_shared<Fifo<T>>());
        waiting.push_back(targets.back());
        behind.push_back(in->queue());
        waiting_readers.push_back(unit);
      }
    }
    std::vector<Clocks::Feed> feeds;
    for (Out<T>* out : from) {
      auto queue = std::make_shared<Fifo<T>>();
      feeds.push_back({output(ports, *out, queue, depth), mover<T>(queue, targets)});
    }
    if (to.size() == 1) {
      clocks_.feed(readers.front(), std::move(feeds));
      return;
    }
    const auto branches = clocks_.fork(std::move(feeds), readers, waiting.size(), depth);
    for (std::size_t i = 0; i < branches.size(); ++i) {
      clocks_.feed(waiting_readers[i], {{branches[i], mover<T>(waiting[i], {behind[i]})}});
    }
  }
  template <class Job, class Numbered>
  void repeat(const JoinPorts& ports, const std::vector<Out<Job>*>& from, In<Numbered>& to,
              const Shared<Job>& counted, unsigned depth) {
    struct State {
      Job job;
      std::uint64_t number = 0;
    };
    const auto state = std::make_shared<State>();
    std::vector<Clocks::Feed> feeds;
    for (Out<Job>* out : from) {
      auto queue = std::make_shared<Fifo<Job>>();
      feeds.push_back({output(ports, *out, queue, depth), [=, numbered = to.queue()] {
                         if (state->number == 0) {
                           state->job = queue->pop();
                           counted->push(state->job);
                           counted->pop();
                         }
                         const bool last = send_numbered(state->job, state->number++, *numbered);
                         if (last) state->number = 0;
                         return last;
                       }});
    }
    clocks_.feed(ports.unit_of(&to), std::move(feeds));
  }
  template <class T, unsigned N, unsigned L>
  void stale_ram(const JoinPorts& ports, RamWrite<T, N>& writer, const RamRead<T, N, L>& reader,
                 const std::shared_ptr<std::vector<T>>& rows) {
    const auto log = std::make_shared<typename RamWrite<T, N>::Log>();
    writer.record(log.get());
    const auto& stages = schedules_.at(modules_.at(ports.unit_of(&reader))).ram_stages;
    const auto stage = stages.find(ports.member_of(&reader));
    clocks_.stale_ram(
        ports.unit_of(&writer), ports.member_of(&writer), stage == stages.end() ? 0 : stage->second,
        [log] { return log->size(); },
        [log, rows] {
          (*rows)[log->front().first] = log->front().second;
          log->erase(log->begin());
        });
  }

  template <class T>
  Shared<T> input(const JoinPorts& ports, const std::string& name, In<T>& to) {
    auto queue = std::make_shared<Fifo<T>>();
    ends_[name] = clocks_.input();
    clocks_.feed(ports.unit_of(&to), {{ends_[name], mover<T>(queue, {to.queue()})}});
    return queue;
  }
  template <class T>
  void output(const JoinPorts& ports, const std::string& name, Out<T>& from,
              const Shared<T>& queue) {
    ends_[name] = output(ports, from, queue, 0);
  }
  template <class T>
  void sink(const JoinPorts& ports, Out<T>& from, const Shared<T>& queue) {
    clocks_.sink({output(ports, from, queue, 0), mover<T>(queue, {})});
  }

  void arrives(const std::string& input, std::uint64_t clock) {
    ends_.at(input)->ready.push_back(clock);
  }
  void run() { clocks_.run(); }
  std::uint64_t first_of(const std::string& output) const {
    const auto& ready = ends_.at(output)->ready;
    return ready.empty() ? Clocks::kNever : ready.front();
  }
  std::uint64_t stalls(const std::string& unit) { return clocks_.stalls(unit); }

 private:
  template <class T>
  Clocks::Queue* output(const JoinPorts& ports, Out<T>& out, const Shared<T>& queue,
                        unsigned depth) {
    out.bind(queue);
    return clocks_.output(ports.unit_of(&out), [queue] { return queue->pushed(); }, depth != 0);
  }
  template <class T>
  static Clocks::Move mover(Shared<T> from, std::vector<Shared<T>> to) {
    return [from = std::move(from), to = std::move(to)] {
      const T token = from->pop();
      for (const auto& queue : to) queue->push(token);
      return true;
    };
  }

  ModuleSchedules schedules_;
  Clocks clocks_;
  std::map<std::string, std::string> modules_;  ///< by unit
  std::map<std::string, Clocks::Queue*> ends_;  ///< inputs and outputs, by channel
};

}  // namespace hls
