// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/join_clocks.h"

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

void JoinClocks::channel(const JoinPorts& ports, const std::vector<OutEnd*>& from,
                         const std::vector<InEnd*>& to, TokenType type, unsigned depth,
                         const std::vector<OutEnd*>& short_fifos) {
  // A reader that waits for other tokens too has a queue of its own behind the fork.
  std::vector<Tokens> targets, waiting, behind;
  std::vector<std::string> readers, waiting_readers;
  for (const InEnd* in : to) {
    const std::string unit = ports.unit_of(in);
    if (to.size() == 1 || ports.inputs_of(unit) == 1) {
      targets.push_back(in->tokens());
      readers.push_back(unit);
    } else {
      targets.push_back(type.make_queue());
      waiting.push_back(targets.back());
      behind.push_back(in->tokens());
      waiting_readers.push_back(unit);
    }
  }
  Source source = merge(ports, from, type, depth, short_fifos);
  if (to.size() == 1 && ports.inputs_of(readers.front()) > 1) source = buffer({source}, type);
  const Clocks::Feed feed{source.queue, mover(source.tokens, targets)};
  if (to.size() == 1) {
    clocks_.feed(readers.front(), feed);
    return;
  }
  const auto branches = clocks_.fork(feed, readers, waiting.size(), depth);
  for (std::size_t i = 0; i < branches.size(); ++i) {
    clocks_.feed(waiting_readers[i], {branches[i], mover(waiting[i], {behind[i]})});
  }
}

void JoinClocks::repeat(const JoinPorts& ports, const std::vector<OutEnd*>& from, const InEnd& to,
                        TokenType type, SendNumbered send, std::shared_ptr<std::uint64_t> sent,
                        unsigned depth, const std::vector<OutEnd*>& short_fifos) {
  const Source source = merge(ports, from, type, depth, short_fifos);
  const auto move = [jobs = source.tokens, sent, send, numbered = to.tokens(),
                     number = std::uint64_t{0}]() mutable {
    if (number == 0) ++*sent;
    const bool last = send(*jobs, number++, *numbered);
    if (last) number = 0;
    return last;
  };
  clocks_.feed(ports.unit_of(&to), {source.queue, move});
}

JoinClocks::Source JoinClocks::merge(const JoinPorts& ports, const std::vector<OutEnd*>& from,
                                     TokenType type, unsigned depth,
                                     const std::vector<OutEnd*>& short_fifos) {
  std::vector<Source> sources;
  for (OutEnd* out : from) {
    const Tokens tokens = type.make_queue();
    const bool is_short = std::ranges::find(short_fifos, out) != short_fifos.end();
    sources.push_back({output(ports, *out, tokens, is_short ? 0 : depth), tokens});
  }
  return sources.size() == 1 ? sources.front() : buffer(sources, type);
}

JoinClocks::Source JoinClocks::buffer(const std::vector<Source>& sources, TokenType type) {
  const Tokens buffered = type.make_queue();
  std::vector<Clocks::Feed> feeds;
  for (const Source& s : sources) feeds.push_back({s.queue, mover(s.tokens, {buffered})});
  return {clocks_.merge(std::move(feeds)), buffered};
}

void JoinClocks::torn_ram(const JoinPorts& ports, TornRam ram) {
  const auto& stages = schedules_.at(modules_.at(ports.unit_of(ram.reader))).ram_stages;
  const auto stage = stages.find(ports.member_of(ram.reader));
  clocks_.torn_ram(ports.unit_of(ram.writer), ports.member_of(ram.writer),
                   stage == stages.end() ? 0 : stage->second, std::move(ram.logged),
                   std::move(ram.tear), std::move(ram.land));
}

Tokens JoinClocks::input(const JoinPorts& ports, const std::string& name, const InEnd& to,
                         TokenType type) {
  Tokens queue = type.make_queue();
  ends_[name] = clocks_.input();
  clocks_.feed(ports.unit_of(&to), {ends_[name], mover(queue, {to.tokens()})});
  return queue;
}
void JoinClocks::output(const JoinPorts& ports, const std::string& name, OutEnd& from,
                        const Tokens& queue) {
  ends_[name] = output(ports, from, queue, 0);
}
void JoinClocks::sink(const JoinPorts& ports, OutEnd& from, const Tokens& queue) {
  clocks_.sink({output(ports, from, queue, 0), mover(queue, {})});
}

std::uint64_t JoinClocks::first_of(const std::string& output) const {
  const auto& ready = ends_.at(output)->ready;
  return ready.empty() ? Clocks::kNever : ready.front();
}

Clocks::Queue* JoinClocks::output(const JoinPorts& ports, OutEnd& out, const Tokens& queue,
                                  unsigned depth) {
  out.bind_tokens(queue);
  return clocks_.output(ports.unit_of(&out), [queue] { return queue->pushed(); }, depth != 0);
}

}  // namespace hls
