// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/clocks.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hls {

void Clocks::unit(const std::string& name, const ModuleSchedule& schedule,
                  std::function<void()> run) {
  units_.push_back(
      {.number = units_.size(), .name = name, .schedule = schedule, .run = std::move(run)});
}

Clocks::Queue* Clocks::output(const std::string& name, std::shared_ptr<TokenQueue> tokens,
                              bool bounded) {
  Unit& unit = find(name);
  Queue* queue = add_queue(bounded ? 0 : unit.schedule.room);
  unit.outputs.push_back({queue, std::move(tokens)});
  if (!bounded) unit.refusing.push_back(queue);
  return queue;
}

void Clocks::feed(const std::string& name, Feed feed) {
  find(name).feeds.push_back(std::move(feed));
}

Clocks::Queue* Clocks::merge(std::vector<Feed> feeds) {
  Queue* buffer = add_queue(Queue::kBufferPlaces);
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
    fork.branches.push_back(add_queue(depth));
  }
  forks_.push_back(std::move(fork));
  return forks_.back().branches;
}

void Clocks::sink(Feed feed) { sinks_.push_back({.feed = std::move(feed)}); }

void Clocks::device(Queue* requests, Queue* answers, Queue* writes, Device& device) {
  outsides_.push_back(
      {.requests = requests, .answers = answers, .writes = writes, .device = &device});
}

void Clocks::torn_ram(const std::string& writer, const std::string& port, const std::string& reader,
                      unsigned read_stage, std::function<std::uint64_t()> logged,
                      std::function<void(std::size_t)> tear, std::function<void()> land) {
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
  if (writer == reader && stage->second == read_stage) {
    throw std::invalid_argument("unit '" + writer + "' writes '" + port + "' in stage " +
                                std::to_string(read_stage) + ", in which it reads it too; it " +
                                "would tear its own row, which is not counted");
  }
  rams_.push_back({.own = writer == reader,
                   .after = stage->second + 1 - read_stage,
                   .logged = std::move(logged),
                   .tear = std::move(tear),
                   .land = std::move(land)});
  unit.rams.push_back(&rams_.back());
}

void Clocks::run() {
  number_actors();
  wheel_.run([this](std::size_t actor, std::uint64_t now) {
    actors_[actor].act(*this, actors_[actor].self, now);
  });
  if (watch_ == nullptr) return;
  for (const Unit& unit : units_) tell(unit, now_ + 1);
  for (const Fork& fork : forks_) tell(fork, now_ + 1);
}

template <class Actor>
void Clocks::see(Actor& actor, Queue* full, std::uint64_t now) {
  Waiting& waiting = actor.waiting;
  if (full != nullptr && full == waiting.full) return;
  tell(actor, now);
  waiting = {.told = full == nullptr ? now + 1 : now, .full = full};
}

void Clocks::tell(const Unit& unit, std::uint64_t now) {
  const auto [told, full] = unit.waiting;
  if (told >= now || unit.feeds.empty()) return;
  if (full != nullptr) {
    watch_->waited(unit.number, full->number, Lack::kRoom, told, now);
    return;
  }
  const auto last = std::ranges::max_element(unit.feeds, {},
                                             [](const Feed& feed) { return feed.queue->front(); });
  watch_->waited(unit.number, last->queue->number, Lack::kToken, told, now);
}

void Clocks::tell(const Fork& fork, std::uint64_t now) {
  const auto [told, full] = fork.waiting;
  if (told >= now) return;
  for (const Unit* reader : fork.readers) {
    // For the other readers the fork still holds the token back.
    const bool own =
        full != nullptr && std::ranges::find(reader->refusing, full) != reader->refusing.end();
    watch_->waited(reader->number, own ? full->number : fork.feed.queue->number,
                   own ? Lack::kRoom : Lack::kToken, told, now);
  }
}

Clocks::Unit& Clocks::find(const std::string& name) {
  const auto found = std::ranges::find(units_, name, &Unit::name);
  if (found == units_.end()) throw std::logic_error("no unit has the name " + name);
  return *found;
}

template <auto kAct, class Self>
std::size_t Clocks::number(Self& self) {
  const auto act = [](Clocks& clocks, void* actor, std::uint64_t now) {
    (clocks.*kAct)(*static_cast<Self*>(actor), now);
  };
  actors_.push_back({act, &self});
  return actors_.size() - 1;
}

void Clocks::number_actors() {
  actors_.clear();
  for (Ram& ram : rams_) ram.landing = number<&Clocks::land>(ram);
  for (Sink& sink : sinks_) sink.feed.queue->reader = number<&Clocks::drain>(sink);
  for (Outside& outside : outsides_) {
    outside.actor = number<&Clocks::serve>(outside);
    outside.requests->reader = outside.actor;
    if (outside.writes != nullptr) outside.writes->reader = outside.actor;
  }
  for (Arbiter& arbiter : arbiters_) {
    arbiter.actor = number<&Clocks::arbitrate>(arbiter);
    for (const Feed& feed : arbiter.feeds) feed.queue->reader = arbiter.actor;
  }
  for (Fork& fork : forks_) {
    fork.actor = number<&Clocks::pass>(fork);
    fork.feed.queue->reader = fork.actor;
  }
  const auto tears_for_others = [](const Unit& unit) {
    return std::ranges::any_of(unit.rams, [](const Ram* ram) { return !ram->own; });
  };
  const auto number_units = [&](bool tear_for_others) {
    for (Unit& unit : units_) {
      if (tears_for_others(unit) != tear_for_others) continue;
      unit.actor = number<&Clocks::fire>(unit);
      for (const Feed& feed : unit.feeds) feed.queue->reader = unit.actor;
    }
  };
  const auto number_marks = [this](bool own) {
    for (Ram& ram : rams_) {
      if (ram.own == own) ram.tearing = number<&Clocks::tear>(ram);
    }
  };
  // Readers see in the same clock that a row is torn. A row that a unit reads and writes was torn
  // by one of its earlier transactions.
  number_marks(true);
  number_units(true);
  number_marks(false);
  number_units(false);
  wheel_ = TimingWheel(actors_.size());
  for (const Queue& queue : queues_) {
    if (!queue.empty()) wheel_.wake(queue.reader, queue.front());
  }
}

bool Clocks::has_room(Queue& queue, std::size_t waiting, std::uint64_t now) {
  if (queue.has_room(now)) return true;
  const std::uint64_t from = queue.has_room_from(now);
  if (from == kNever) {
    queue.waits_for_room = waiting;
  } else {
    wheel_.wake(waiting, from);
  }
  return false;
}

void Clocks::take(const Feed& feed, std::uint64_t now) {
  Queue& queue = *feed.queue;
  if (feed.move && !feed.move()) {
    wheel_.wake(queue.reader, now + 1);
    return;
  }
  if (watch_ != nullptr) {
    const auto [from, to] = queue.stay(now);
    watch_->passed(queue.number, from, to);
  }
  queue.pop(now);
  if (!queue.empty()) wheel_.wake(queue.reader, std::max(now + 1, queue.front()));
  if (queue.waits_for_room == kNobody) return;
  wheel_.wake(queue.waits_for_room, now + 1);
  queue.waits_for_room = kNobody;
}

void Clocks::push(Queue& queue, std::uint64_t ready) {
  const bool is_first = queue.empty();
  queue.push(ready);
  if (is_first && queue.reader != kNobody) wheel_.wake(queue.reader, queue.front());
}

void Clocks::drain(Sink& sink, std::uint64_t now) {
  if (sink.feed.queue->offers(now)) take(sink.feed, now);
}

void Clocks::serve(Outside& outside, std::uint64_t now) {
  Device& device = *outside.device;
  if (outside.writes != nullptr && outside.writes->offers(now)) {
    take({outside.writes}, now);
    device.take_write(now);
  }
  if (outside.requests->offers(now)) {
    take({outside.requests}, now);
    device.take(now);
  }
  const std::size_t answers = device.answer(now);
  for (std::size_t i = 0; i < answers; ++i) push(*outside.answers, now + 1 + i);
  if (device.next() != kNever) wheel_.wake(outside.actor, std::max(now + 1, device.next()));
}

void Clocks::arbitrate(Arbiter& arbiter, std::uint64_t now) {
  const auto offers = [now](const Feed& feed) { return feed.queue->offers(now); };
  if (!has_room(*arbiter.buffer, arbiter.actor, now)) return;
  const std::size_t sender = arbiter.granted;
  const std::size_t count = arbiter.feeds.size();
  for (std::size_t after = 1, other = sender; after < count; ++after) {
    if (++other == count) other = 0;
    if (!offers(arbiter.feeds[other])) continue;
    arbiter.granted = other;
    wheel_.wake(arbiter.actor, now + 1);
    break;
  }
  if (!offers(arbiter.feeds[sender])) return;
  take(arbiter.feeds[sender], now);
  push(*arbiter.buffer, now + 1);
}

void Clocks::pass(Fork& fork, std::uint64_t now) {
  if (!fork.feed.queue->offers(now)) return;
  Queue* full = nullptr;
  for (const Unit* reader : fork.readers) {
    if ((full = without_room(reader->refusing, fork.actor, now)) != nullptr) break;
  }
  if (full == nullptr) full = without_room(fork.branches, fork.actor, now);
  if (watch_ != nullptr) see(fork, full, now);
  if (full != nullptr) return;
  take(fork.feed, now);
  for (const Unit* reader : fork.readers) wheel_.wake(reader->actor, now);
  for (Queue* branch : fork.branches) push(*branch, now + 1);
}

void Clocks::fire(Unit& unit, std::uint64_t now) {
  if (!unit.waits_for_fork) {
    for (const Feed& feed : unit.feeds) {
      if (!feed.queue->offers(now)) return;
    }
    Queue* full = without_room(unit.refusing, unit.actor, now);
    if (watch_ != nullptr) see(unit, full, now);
    if (full != nullptr) {
      if (unit.stalled_from != kNever) return;
      unit.stalled_from = now;
      ++unit.stalls;
      return;
    }
    if (unit.stalled_from != kNever) unit.stalls += now - unit.stalled_from - 1;
    unit.stalled_from = kNever;
    for (const Feed& feed : unit.feeds) take(feed, now);
  }
  now_ = now;
  unit.run();
  for (Output& output : unit.outputs) {
    if (output.tokens->pushed() == output.sent) continue;
    ++output.sent;
    push(*output.queue, now + unit.schedule.stages);
  }
  for (Ram* ram : unit.rams) {
    while (ram->due.size() < ram->logged()) {
      ram->due.push_back(now + ram->after);
      wheel_.wake(ram->tearing, ram->due.back() - 1);
      wheel_.wake(ram->landing, ram->due.back());
    }
  }
}

void Clocks::land(Ram& ram, std::uint64_t now) {
  for (; !ram.due.empty() && ram.due.front() <= now; ram.due.pop_front()) ram.land();
}

void Clocks::tear(Ram& ram, std::uint64_t now) {
  for (std::size_t i = 0; i < ram.due.size() && ram.due[i] <= now + 1; ++i) ram.tear(i);
}

}  // namespace hls
