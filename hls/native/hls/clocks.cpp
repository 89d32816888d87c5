// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/clocks.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hls {

void Clocks::unit(const std::string& name, const ModuleSchedule& schedule,
                  std::function<void()> run) {
  units_.push_back({.name = name, .schedule = schedule, .run = std::move(run)});
}

Clocks::Queue* Clocks::output(const std::string& name, std::function<std::uint64_t()> pushed,
                              bool bounded) {
  Unit& unit = find(name);
  queues_.push_back({.pushed = std::move(pushed), .room = bounded ? 0 : unit.schedule.room});
  unit.outputs.push_back(&queues_.back());
  return &queues_.back();
}

void Clocks::feed(const std::string& name, Feed feed) {
  find(name).feeds.push_back(std::move(feed));
}

Clocks::Queue* Clocks::merge(std::vector<Feed> feeds) {
  constexpr unsigned kPlaces = 2;  // of hls_buffer.v
  Queue* buffer = &queues_.emplace_back(Queue{.room = kPlaces});
  arbiters_.push_back({.feeds = std::move(feeds), .buffer = buffer});
  return buffer;
}

std::vector<Clocks::Queue*> Clocks::fork(Feed feed, const std::vector<std::string>& readers,
                                         std::size_t queues, unsigned depth) {
  Fork fork{.feed = std::move(feed)};
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

void Clocks::sink(Feed feed) { sinks_.push_back(std::move(feed)); }

void Clocks::torn_ram(const std::string& writer, const std::string& port, unsigned read_stage,
                      std::function<std::uint64_t()> logged, std::function<void(std::size_t)> tear,
                      std::function<void()> land) {
  Unit& unit = find(writer);
  const auto stage = unit.schedule.ram_stages.find(port);
  if (stage == unit.schedule.ram_stages.end()) {
    throw std::invalid_argument("the schedule of unit '" + writer + "' does not say in which " +
                                "stage it writes '" + port + "'");
  }
  if (stage->second < read_stage) {
    throw std::invalid_argument("unit '" + writer + "' writes '" + port + "' in stage " +
                                std::to_string(stage->second) + ", before its reader reads it in " +
                                std::to_string(read_stage) + "; such rows are not counted");
  }
  rams_.push_back({.after = stage->second + 1 - read_stage,
                   .logged = std::move(logged),
                   .tear = std::move(tear),
                   .land = std::move(land)});
  unit.rams.push_back(&rams_.back());
}

void Clocks::run() {
  for (std::uint64_t now = next(0); now != kNever;) now = tick(now) ? now + 1 : next(now + 1);
}

bool Clocks::Queue::has_room(std::uint64_t now) const {
  if (room == 0) return true;
  std::size_t waiting = taken_at == now ? 1 : 0;
  for (auto at = ready.begin(); at != ready.end() && *at <= now; ++at) ++waiting;
  return waiting < room;
}

void Clocks::Feed::take(std::uint64_t now) const {
  if (!move()) return;
  queue->ready.pop_front();
  queue->taken_at = now;
}

void Clocks::Ram::land_until(std::uint64_t now) {
  for (; !due.empty() && due.front() <= now; due.pop_front()) land();
}

void Clocks::Ram::tear_at(std::uint64_t now) const {
  for (std::size_t i = 0; i < due.size() && due[i] <= now + 1; ++i) tear(i);
}

bool Clocks::Unit::has_room(std::uint64_t now) const {
  return std::ranges::all_of(outputs, [now](const Queue* q) { return q->has_room(now); });
}

Clocks::Unit& Clocks::find(const std::string& name) {
  const auto found = std::ranges::find(units_, name, &Unit::name);
  if (found == units_.end()) throw std::logic_error("no unit has the name " + name);
  return *found;
}

bool Clocks::tick(std::uint64_t now) {
  bool moved = false;
  for (Ram& ram : rams_) ram.land_until(now);
  for (const Feed& sink : sinks_) {
    if (sink.queue->offers(now)) {
      sink.take(now);
      moved = true;
    }
  }
  for (Arbiter& arbiter : arbiters_) moved |= arbitrate(arbiter, now);
  for (Fork& fork : forks_) moved |= pass(fork, now);
  // Readers see in the same clock that a row is torn.
  for (Unit& unit : units_) moved |= !unit.rams.empty() && fire(unit, now);
  for (const Ram& ram : rams_) ram.tear_at(now);
  for (Unit& unit : units_) moved |= unit.rams.empty() && fire(unit, now);
  return moved;
}

bool Clocks::arbitrate(Arbiter& arbiter, std::uint64_t now) {
  if (!arbiter.buffer->has_room(now)) return false;
  const std::size_t sender = arbiter.granted;
  const std::size_t count = arbiter.feeds.size();
  for (std::size_t after = 1; after < count; ++after) {
    const std::size_t other = (sender + after) % count;
    if (!arbiter.feeds[other].queue->offers(now)) continue;
    arbiter.granted = other;
    break;
  }
  const Feed& feed = arbiter.feeds[sender];
  if (!feed.queue->offers(now)) return arbiter.granted != sender;
  feed.take(now);
  arbiter.buffer->ready.push_back(now + 1);
  return true;
}

bool Clocks::pass(Fork& fork, std::uint64_t now) {
  if (!fork.feed.queue->offers(now)) return false;
  const bool ready =
      std::ranges::all_of(fork.readers, [now](const Unit* u) { return u->has_room(now); }) &&
      std::ranges::all_of(fork.branches, [now](const Queue* q) { return q->has_room(now); });
  if (!ready) return false;
  fork.feed.take(now);
  for (Unit* reader : fork.readers) reader->forked_at = now;
  for (Queue* branch : fork.branches) branch->ready.push_back(now + 1);
  return true;
}

bool Clocks::fire(Unit& unit, std::uint64_t now) {
  if (unit.waits_for_fork) {
    if (unit.forked_at != now) return false;
  } else {
    const bool tokens =
        std::ranges::all_of(unit.feeds, [now](const Feed& f) { return f.queue->offers(now); });
    const bool room = unit.has_room(now);
    unit.stalls += tokens && !room;
    if (!tokens || !room) return false;
    for (const Feed& feed : unit.feeds) feed.take(now);
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

std::uint64_t Clocks::next(std::uint64_t now) const {
  std::uint64_t soonest = kNever;
  for (const Queue& queue : queues_) {
    if (!queue.ready.empty() && queue.ready.front() >= now) {
      soonest = std::min(soonest, queue.ready.front());
    }
  }
  return soonest;
}

}  // namespace hls
