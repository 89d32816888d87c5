// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "hls/join.h"

#include <stdexcept>
#include <utility>

namespace hls {
namespace {

std::vector<std::string> names_of(const JoinPorts& ports, const auto& ends) {
  std::vector<std::string> names;
  for (const void* end : ends) names.push_back(ports.name_of(end));
  return names;
}

}  // namespace

void Join::add_unit(const std::string& plain_name, const std::string& module, UnitCalls unit,
                    const std::vector<PortOfUnit>& ports) {
  const std::string name = prefix_ + plain_name;
  UnitRecord record{name, module, {}, group_};
  ports_.add(record, ports);
  record_.units.push_back(std::move(record));
  const std::size_t number = record_.units.size() - 1;
  const auto run = [unit, number, watch = watch_.get()](std::uint64_t& transactions) {
    bool progress = false;
    while (const std::size_t ready = unit.ready(unit.self)) {
      if (!*watch) {
        unit.run(unit.self, ready);
      } else {
        for (std::size_t i = 0; i < ready; ++i) {
          (*watch)(number, 0);
          unit.run(unit.self, 1);
        }
      }
      transactions += ready;
      progress = true;
    }
    return progress;
  };
  Process& process = processes_.emplace_back(Process{name, 0, run});
  if (clocks_) {
    clocks_->unit(name, module,
                  [&process, unit, number, watch = watch_.get(), clocks = clocks_.get()] {
                    if (*watch) (*watch)(number, clocks->now());
                    unit.run(unit.self, 1);
                    ++process.transactions;
                  });
  }
}

void Join::add_ram(RamRecord record, const void* writer, const std::vector<const void*>& readers) {
  record.writer = ports_.name_of(writer);
  record.readers = names_of(ports_, readers);
  record_.rams.push_back(std::move(record));
}

void Join::add_channel(const std::string& name, const std::vector<OutEnd*>& from,
                       const std::vector<InEnd*>& to, TokenType type, unsigned depth,
                       const std::vector<OutEnd*>& short_fifos) {
  const ChannelRecord record{
      prefix_ + name, names_of(ports_, from), names_of(ports_, to),         type.width,
      depth,          ChannelKind::kChannel,  names_of(ports_, short_fifos)};
  for (InEnd* in : to) in->bind_tokens(type.make_queue());
  if (clocks_) {
    clocks_->channel(record.name, ports_, from, to, type, depth, short_fifos);
  } else {
    for (OutEnd* out : from) {
      for (const InEnd* in : to) out->bind_tokens(in->tokens());
    }
  }
  count(record, [queue = to.empty() ? nullptr : to.front()->tokens()] {
    return queue ? queue->pushed() : 0;
  });
}

void Join::add_repeat(const std::string& name, const std::vector<OutEnd*>& from, const InEnd& to,
                      TokenType type, unsigned repeat_width, SendNumbered send, unsigned depth,
                      const std::vector<OutEnd*>& short_fifos) {
  ChannelRecord record{
      prefix_ + name, names_of(ports_, from), {ports_.name_of(&to)},        type.width,
      depth,          ChannelKind::kRepeat,   names_of(ports_, short_fifos)};
  record.repeat_width = repeat_width;
  if (clocks_) {
    const auto sent = std::make_shared<std::uint64_t>(0);
    clocks_->repeat(record.name, ports_, from, to, type, send, sent, depth, short_fifos);
    count(record, [sent] { return *sent; });
    return;
  }
  const std::shared_ptr<TokenQueue> jobs = type.make_queue();
  for (OutEnd* out : from) out->bind_tokens(jobs);
  const auto run = [jobs, send, numbered = to.tokens()](std::uint64_t&) {
    bool progress = false;
    for (; jobs->has_tokens(); progress = true) {
      std::uint64_t number = 0;
      while (!send(*jobs, number, *numbered)) ++number;
    }
    return progress;
  };
  processes_.push_back({"", 0, run});
  count(record, [jobs] { return jobs->pushed(); });
}

std::shared_ptr<TokenQueue> Join::add_input(const std::string& name, InEnd& to, TokenType type) {
  to.bind_tokens(type.make_queue());
  record_.channels.push_back(
      {prefix_ + name, {}, {ports_.name_of(&to)}, type.width, 0, ChannelKind::kInput});
  if (clocks_) clocks_->input(ports_, name, to);
  return to.tokens();
}

std::shared_ptr<TokenQueue> Join::add_output(const std::string& name, OutEnd& from,
                                             TokenType type) {
  std::shared_ptr<TokenQueue> queue = type.make_queue();
  record_.channels.push_back(
      {prefix_ + name, {ports_.name_of(&from)}, {}, type.width, 0, ChannelKind::kOutput});
  if (clocks_) {
    clocks_->output(ports_, name, from, queue);
  } else {
    from.bind_tokens(queue);
  }
  outputs_[name] = queue;
  return queue;
}

void Join::attach(const std::string& requests, const std::string& answers, Device& device,
                  const std::string& writes) {
  if (clocks_) {
    clocks_->attach(requests, answers, writes, device);
    return;
  }
  const auto served = [&device](const std::shared_ptr<TokenQueue>& queue, auto take) {
    const bool any = queue->has_tokens();
    while (queue->has_tokens()) (device.*take)(0);
    while (device.next() != kNever) device.answer(device.next());
    return any;
  };
  processes_.push_back({"", 0, [served, queue = outputs_.at(requests)](std::uint64_t&) {
                          return served(queue, &Device::take);
                        }});
  if (writes.empty()) return;
  processes_.push_back({"", 0, [served, queue = outputs_.at(writes)](std::uint64_t&) {
                          return served(queue, &Device::take_write);
                        }});
}

void Join::add_sink(const std::string& name, OutEnd& from, TokenType type) {
  const std::shared_ptr<TokenQueue> queue = type.make_queue();
  if (clocks_) {
    clocks_->sink(prefix_ + name, ports_, from, queue);
  } else {
    from.bind_tokens(queue);
    const auto drop = [queue](std::uint64_t&) {
      while (queue->has_tokens()) queue->move_to({});
      return false;
    };
    processes_.push_back({"", 0, drop});
  }
  count({prefix_ + name, {ports_.name_of(&from)}, {}, type.width, 0, ChannelKind::kSink},
        [queue] { return queue->pushed(); });
}

void Join::count(const ChannelRecord& record, std::function<std::uint64_t()> tokens) {
  record_.channels.push_back(record);
  tokens_.emplace_back(record.name, std::move(tokens));
}

void Join::depends_on_order(const std::vector<std::string>& names) {
  for (const std::string& plain_name : names) {
    const std::string name = prefix_ + plain_name;
    bool known = false;
    const auto mark = [&](auto& records) {
      for (auto& record : records) {
        if (record.name == name) known = record.order_dependent = true;
      }
    };
    mark(record_.channels);
    mark(record_.units);
    if (!known) throw std::logic_error("no channel and no unit has the name " + name);
  }
}

void Join::run() {
  bool progress = true;
  while (progress) {
    progress = false;
    for (Process& process : processes_) progress |= process.run(process.transactions);
  }
}

std::map<std::string, std::uint64_t> Join::counters() const {
  std::map<std::string, std::uint64_t> values;
  for (const Process& process : processes_) {
    if (process.name.empty()) continue;
    values[counter_name(process.name, Counted::kTransactions)] = process.transactions;
    if (clocks_) {
      values[counter_name(process.name, Counted::kStalls)] = clocks_->stalls(process.name);
    }
  }
  for (const auto& [name, tokens] : tokens_) {
    values[counter_name(name, Counted::kTokens)] = tokens();
  }
  return values;
}

}  // namespace hls
