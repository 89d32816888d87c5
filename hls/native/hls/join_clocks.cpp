// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/join_clocks.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hls {
namespace {

using Tokens = JoinClocks::Tokens;

Clocks::Move mover(Tokens from, std::vector<Tokens> to) {
  return [from = std::move(from), to = std::move(to)] {
    from->move_to(to);
    return true;
  };
}

}  // namespace

void JoinClocks::unit(const std::string& name, const std::string& module,
                      std::function<void()> run) {
  const auto found = schedules_.find(module);
  if (found == schedules_.end()) {
    throw std::invalid_argument("there is no schedule of module '" + module + "'");
  }
  modules_[name] = module;
  clocks_.unit(name, found->second, std::move(run));
}

void JoinClocks::channel(const std::string& name, const JoinPorts& ports,
                         const std::vector<OutEnd*>& from, const std::vector<InEnd*>& to,
                         TokenType type, unsigned depth, const std::vector<OutEnd*>& short_fifos) {
  const Source source = merge(name, ports, from, type, depth, short_fifos);
  if (to.size() == 1) {
    const std::string unit = ports.unit_of(to.front());
    if (ports.inputs_of(unit) > 1) source.queue->put_buffer_behind();
    to.front()->bind_tokens(source.tokens);
    clocks_.feed(unit, {source.queue});
    return;
  }
  std::vector<Tokens> targets;
  std::vector<std::string> readers, waiting, waiting_ports;
  for (const InEnd* in : to) {
    targets.push_back(in->tokens());
    const std::string unit = ports.unit_of(in);
    // A reader that waits for other tokens too has a queue of its own behind the fork.
    const bool waits = ports.inputs_of(unit) > 1;
    (waits ? waiting : readers).push_back(unit);
    if (waits) waiting_ports.push_back(ports.name_of(in));
  }
  const auto branches =
      clocks_.fork({source.queue, mover(source.tokens, targets)}, readers, waiting.size(), depth);
  for (std::size_t i = 0; i < branches.size(); ++i) {
    clocks_.feed(waiting[i], {add_fifo(branches[i], {name, waiting_ports[i], depth})});
  }
}

void JoinClocks::repeat(const std::string& name, const JoinPorts& ports,
                        const std::vector<OutEnd*>& from, const InEnd& to, TokenType type,
                        SendNumbered send, std::shared_ptr<std::uint64_t> sent, unsigned depth,
                        const std::vector<OutEnd*>& short_fifos) {
  const Source source = merge(name, ports, from, type, depth, short_fifos);
  const auto move = [jobs = source.tokens, sent, send, numbered = to.tokens(),
                     number = std::uint64_t{0}]() mutable {
    if (number == 0) ++*sent;
    const bool last = send(*jobs, number++, *numbered);
    if (last) number = 0;
    return last;
  };
  clocks_.feed(ports.unit_of(&to), {source.queue, move});
}

JoinClocks::Source JoinClocks::merge(const std::string& name, const JoinPorts& ports,
                                     const std::vector<OutEnd*>& from, TokenType type,
                                     unsigned depth, const std::vector<OutEnd*>& short_fifos) {
  std::vector<Source> sources;
  for (OutEnd* out : from) {
    const Tokens tokens = type.make_queue();
    const bool is_short = std::ranges::find(short_fifos, out) != short_fifos.end();
    sources.push_back({output(name, ports, *out, tokens, is_short ? 0 : depth), tokens});
  }
  if (sources.size() == 1) return sources.front();
  const Tokens buffered = type.make_queue();
  std::vector<Clocks::Feed> feeds;
  for (const Source& s : sources) feeds.push_back({s.queue, mover(s.tokens, {buffered})});
  Clocks::Queue* buffer = clocks_.merge(std::move(feeds));
  return {add_fifo(buffer, {name, {}, Clocks::Queue::kBufferPlaces}), buffered};
}

void JoinClocks::torn_ram(const JoinPorts& ports, TornRam ram) {
  const std::string reader = ports.unit_of(ram.reader);
  const auto& stages = schedules_.at(modules_.at(reader)).ram_stages;
  const auto stage = stages.find(ports.member_of(ram.reader));
  clocks_.torn_ram(ports.unit_of(ram.writer), ports.member_of(ram.writer), reader,
                   stage == stages.end() ? 0 : stage->second, std::move(ram.logged),
                   std::move(ram.tear), std::move(ram.land));
}

void JoinClocks::input(const JoinPorts& ports, const std::string& name, const InEnd& to) {
  ends_[name] = add_fifo(clocks_.input(), {name, {}, 0});
  clocks_.feed(ports.unit_of(&to), {ends_[name]});
}
void JoinClocks::output(const JoinPorts& ports, const std::string& name, OutEnd& from,
                        const Tokens& queue) {
  ends_[name] = output(name, ports, from, queue, 0);
}
void JoinClocks::sink(const std::string& name, const JoinPorts& ports, OutEnd& from,
                      const Tokens& queue) {
  clocks_.sink({output(name, ports, from, queue, 0), mover(queue, {})});
}

std::uint64_t JoinClocks::first_of(const std::string& output) const {
  return ends_.at(output)->front();
}

Clocks::Queue* JoinClocks::output(const std::string& name, const JoinPorts& ports, OutEnd& out,
                                  const Tokens& queue, unsigned depth) {
  out.bind_tokens(queue);
  const std::string unit = ports.unit_of(&out);
  const ModuleSchedule& schedule = schedules_.at(modules_.at(unit));
  // Where the writer looks for room, there are places for all that it has begun before.
  return add_fifo(
      clocks_.output(unit, queue, depth != 0),
      {name, ports.name_of(&out), depth != 0 ? depth : schedule.room + schedule.stages - 1});
}

Clocks::Queue* JoinClocks::add_fifo(Clocks::Queue* queue, FifoRecord record) {
  fifos_.resize(std::max(fifos_.size(), queue->number + 1));
  fifos_[queue->number] = std::move(record);
  return queue;
}

}  // namespace hls
