// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// How units are joined, written once: a join connects the ports of native units so that they run as
// the model, and records what it connected, from which the Verilog top and the block diagram are
// made (hls/compiler/join). Several writers of a channel meet in an arbiter, several readers are
// fed by a fork, a job channel is repeated, a RAM with several readers has a copy for each. A join
// that knows the units' schedules runs them clock by clock (clocks.h): slower, to the same results.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hls/clocks.h"
#include "hls/join_record.h"
#include "hls/ports.h"

namespace hls {

class Join {
 public:
  Join() = default;
  /// Units run clock by clock as these schedules say. Throws std::invalid_argument, here or when a
  /// unit is named, where a schedule is missing.
  explicit Join(Schedule schedule)
      : schedule_(std::move(schedule)), clocks_(std::make_unique<Clocks>()) {}

  /// Block diagrams show the units that follow under this name.
  void group(const std::string& name) { group_ = name; }

  /// Makes a unit known; its Verilog module has the name `module`.
  template <class U>
  void unit(const std::string& name, const std::string& module, U& unit) {
    UnitRecord record{name, module, {}, group_};
    const std::vector<std::string> names = split_names(U::hls_field_names());
    std::size_t index = 0;
    std::apply([&](auto&... port) { (add_port(record, names[index++], port), ...); },
               unit.hls_fields());
    record_.units.push_back(std::move(record));
    processes_.push_back(
        {name, 0, [&unit](std::uint64_t& transactions) { return run_unit(unit, transactions); }});
    if (clocks_) {
      const auto found = schedule_.find(module);
      if (found == schedule_.end()) {
        throw std::invalid_argument("there is no schedule of module '" + module + "'");
      }
      clocks_->unit(name, found->second,
                    [&process = processes_.back()] { process.run(process.transactions); });
    }
  }

  /// One channel from any of `from` to all of `to`. `depth`, if not 0, promises that there are
  /// never more tokens on the way in it: its FIFOs hold them all and never refuse one.
  template <class T>
  void channel(const std::string& name, std::vector<Out<T>*> from, std::vector<In<T>*> to,
               unsigned depth = 0) {
    ChannelRecord record{name, {}, {}, bit_width_of<T>(), depth, ChannelKind::kChannel};
    for (In<T>* in : to) {
      record.to.push_back(port_name(in));
      in->bind(std::make_shared<Fifo<T>>());
    }
    for (Out<T>* out : from) record.from.push_back(port_name(out));
    if (clocks_) {
      clocked_channel(from, to, depth);
    } else {
      for (Out<T>* out : from) {
        for (In<T>* in : to) out->bind(in->queue());
      }
    }
    count(record, [queues = to] {
      return queues.empty() ? std::uint64_t{0} : queues.front()->queue()->pushed();
    });
  }
  template <class T>
  void channel(const std::string& name, Out<T>& from, In<T>& to, unsigned depth = 0) {
    channel<T>(name, {&from}, {&to}, depth);
  }

  /// Sends every job `job.repeat` + 1 times, numbered from 0.
  template <class Job, class Numbered>
  void repeat(const std::string& name, std::vector<Out<Job>*> from, In<Numbered>& to,
              unsigned depth = 0) {
    auto jobs = std::make_shared<Fifo<Job>>();
    to.bind(std::make_shared<Fifo<Numbered>>());
    ChannelRecord record{
        name, {}, {port_name(&to)}, bit_width_of<Job>(), depth, ChannelKind::kRepeat};
    record.repeat_width = bit_width_of<decltype(Job::repeat)>();
    for (Out<Job>* out : from) record.from.push_back(port_name(out));
    if (clocks_) {
      clocked_repeat(from, to, jobs, depth);
    } else {
      for (Out<Job>* out : from) out->bind(jobs);
      processes_.push_back({"", 0, [jobs, out = to.queue()](std::uint64_t&) {
                              bool progress = false;
                              for (; !jobs->empty(); progress = true) {
                                const Job job = jobs->pop();
                                std::uint64_t number = 0;
                                while (!send_numbered(job, number++, *out)) {
                                }
                              }
                              return progress;
                            }});
    }
    count(record, [jobs] { return jobs->pushed(); });
  }

  /// A channel that the outside writes.
  template <class T>
  std::shared_ptr<Fifo<T>> input(const std::string& name, In<T>& to) {
    to.bind(std::make_shared<Fifo<T>>());
    record_.channels.push_back(
        {name, {}, {port_name(&to)}, bit_width_of<T>(), 0, ChannelKind::kInput});
    if (!clocks_) return to.queue();
    auto queue = std::make_shared<Fifo<T>>();
    ends_[name] = clocks_->input();
    clocks_->feed(unit_of(port_name(&to)), {{ends_[name], mover<T>(queue, {to.queue()})}});
    return queue;
  }
  /// A channel that the outside reads.
  template <class T>
  std::shared_ptr<Fifo<T>> output(const std::string& name, Out<T>& from) {
    auto queue = std::make_shared<Fifo<T>>();
    record_.channels.push_back(
        {name, {port_name(&from)}, {}, bit_width_of<T>(), 0, ChannelKind::kOutput});
    if (clocks_) {
      ends_[name] = clocked_output(from, queue, 0);
    } else {
      from.bind(queue);
    }
    return queue;
  }
  /// A channel whose tokens are counted and dropped.
  template <class T>
  void sink(const std::string& name, Out<T>& from) {
    auto queue = std::make_shared<Fifo<T>>();
    if (clocks_) {
      clocks_->sink({clocked_output(from, queue, 0), mover<T>(queue, {})});
    } else {
      from.bind(queue);
      processes_.push_back({"", 0, [queue](std::uint64_t&) {
                              while (!queue->empty()) queue->pop();
                              return false;
                            }});
    }
    ChannelRecord record{name, {port_name(&from)}, {}, bit_width_of<T>(), 0, ChannelKind::kSink};
    count(record, [queue] { return queue->pushed(); });
  }

  /// A RAM between units: one writer, a copy for each reader.
  template <class T, unsigned N, unsigned L>
  void ram(const std::string& name, RamWrite<T, N>& writer, std::vector<RamRead<T, N, L>*> readers,
           Hazard hazard = Hazard::kExclusive) {
    RamRecord record{name, port_name(&writer), {}, bit_width_of<T>(), N, hazard};
    auto rows = std::make_shared<std::vector<T>>(N);
    if (clocks_ && hazard == Hazard::kStale) {
      clocked_ram(writer, *readers.at(0), rows);
    } else {
      writer.bind(rows);
    }
    for (auto* reader : readers) {
      record.readers.push_back(port_name(reader));
      reader->bind(rows);
    }
    record_.rams.push_back(std::move(record));
  }
  /// A RAM whose rows are written whole and read a word at a time, with the word's number in the
  /// highest bits of the address. The words are written one a clock: the row that follows must not
  /// come before the last of them is, nor may one be read that is still to be written.
  template <class T, std::size_t W, unsigned N, unsigned M, unsigned L>
  void ram_of_words(const std::string& name, RamWrite<std::array<T, W>, N>& writer,
                    std::vector<RamRead<T, M, L>*> readers) {
    static_assert(W > 1 && M == W * N && std::has_single_bit(N), "an address is word, row");
    RamRecord record{name, port_name(&writer), {}, bit_width_of<std::array<T, W>>(),
                     N,    Hazard::kExclusive, W};
    auto words = std::make_shared<std::vector<T>>(M);
    writer.bind([words](std::uint64_t row, const std::array<T, W>& written) {
      for (std::size_t w = 0; w < W; ++w) (*words)[w * N + row] = written[w];
    });
    for (auto* reader : readers) {
      record.readers.push_back(port_name(reader));
      reader->bind(words);
    }
    record_.rams.push_back(std::move(record));
  }
  /// A reading or writing port that leaves the chip, on a bank that the outside owns.
  template <class T, unsigned N, unsigned L>
  void bank(const std::string& name, RamRead<T, N, L>& reader,
            std::shared_ptr<std::vector<T>> rows) {
    reader.bind(std::move(rows));
    record_.banks.push_back({name, port_name(&reader), bit_width_of<T>(), N, false});
  }
  template <class T, unsigned N>
  void bank(const std::string& name, RamWrite<T, N>& writer, std::shared_ptr<std::vector<T>> rows) {
    writer.bind(std::move(rows));
    record_.banks.push_back({name, port_name(&writer), bit_width_of<T>(), N, true});
  }

  /// A value set from outside, seen by all of `ports`.
  template <class T>
  void config(const std::string& name, std::shared_ptr<T> value, std::vector<Config<T>*> ports) {
    ConfigRecord record{name, {}, bit_width_of<T>(), false, 0, fields_of<T>()};
    for (Config<T>* port : ports) {
      record.to.push_back(port_name(port));
      port->bind(value);
    }
    record_.configs.push_back(std::move(record));
  }
  /// A value fixed for one port.
  template <class T>
  void constant(Config<T>& port, T value) {
    port.bind(std::make_shared<T>(value));
    record_.configs.push_back(
        {"", {port_name(&port)}, bit_width_of<T>(), true, leaf_to_bits(value).to_u64()});
  }

  /// Says of channels and units, by name, that how much they do depends on the order in which
  /// tokens are served: two runs of the same work may count differently there.
  void depends_on_order(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
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

  /// Says that the top has no counters.
  void leave_out_counters() { record_.counts = false; }

  /// Runs every unit until none has work left.
  void run() {
    bool progress = true;
    while (progress) {
      progress = false;
      for (Process& process : processes_) progress |= process.run(process.transactions);
    }
  }

  /// The next token that the outside has put into an input comes in this clock, not before the one
  /// before it. Only in joins with clocks, like what follows.
  void arrives(const std::string& input, std::uint64_t clock) {
    ends_.at(input)->ready.push_back(clock);
  }
  /// Runs clock by clock until nothing moves any more. Tokens for the outside stay where they are.
  void run_clocks() { clocks_->run(); }
  /// The clock in which the outside can take the first token of an output.
  std::uint64_t first_of(const std::string& output) const {
    const auto& ready = ends_.at(output)->ready;
    return ready.empty() ? Clocks::kNever : ready.front();
  }

  /// Transactions of every unit ("unit.transactions") and tokens of every channel
  /// ("channel.tokens"), and with clocks the stalls of every unit ("unit.stalls").
  std::map<std::string, std::uint64_t> counters() const {
    std::map<std::string, std::uint64_t> values;
    for (const Process& process : processes_) {
      if (process.name.empty()) continue;
      values[process.name + ".transactions"] = process.transactions;
      if (clocks_) values[process.name + ".stalls"] = clocks_->stalls(process.name);
    }
    for (const auto& [name, tokens] : tokens_) values[name + ".tokens"] = tokens();
    return values;
  }

  const JoinRecord& record() const { return record_; }

 private:
  struct Process {
    std::string name;
    std::uint64_t transactions;
    std::function<bool(std::uint64_t&)> run;
  };

  /// Runs a unit until an input is empty; false if one was. Flattened: `step` and all that it calls
  /// is compiled into the loop.
  template <class U>
  [[gnu::flatten]] static bool run_unit(U& unit, std::uint64_t& transactions) {
    bool progress = false;
    while (const std::size_t ready = transactions_ready(unit)) {
      for (std::size_t i = 0; i < ready; ++i) unit.step();
      transactions += ready;
      progress = true;
    }
    return progress;
  }
  /// Sends the job with a number; true if that was its last.
  template <class Job, class Numbered>
  static bool send_numbered(const Job& job, std::uint64_t number, Fifo<Numbered>& out) {
    Numbered numbered;
    numbered.job = job;
    numbered.index = decltype(numbered.index)::from(number);
    numbered.last = number == job.repeat.to_u64();
    out.push(numbered);
    return numbered.last;
  }

  // What follows makes the same with clocks: every Out has a queue of its own, from which a token
  // is moved to the In in the clock in which its transaction starts.

  template <class T>
  using Shared = std::shared_ptr<Fifo<T>>;

  template <class T>
  Clocks::Queue* clocked_output(Out<T>& out, const Shared<T>& queue, unsigned depth) {
    out.bind(queue);
    return clocks_->output(
        unit_of(port_name(&out)), [queue] { return queue->pushed(); }, depth != 0);
  }
  template <class T>
  static Clocks::Move mover(Shared<T> from, std::vector<Shared<T>> to) {
    return [from = std::move(from), to = std::move(to)] {
      const T token = from->pop();
      for (const auto& queue : to) queue->push(token);
      return true;
    };
  }
  template <class T>
  void clocked_channel(const std::vector<Out<T>*>& from, const std::vector<In<T>*>& to,
                       unsigned depth) {
    // A reader that waits for other tokens too has a queue of its own behind the fork.
    std::vector<Shared<T>> targets, waiting, behind;
    std::vector<std::string> readers, waiting_readers;
    for (In<T>* in : to) {
      const std::string unit = unit_of(port_name(in));
      if (to.size() == 1 || inputs_of(unit) == 1) {
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
      feeds.push_back({clocked_output(*out, queue, depth), mover<T>(queue, targets)});
    }
    if (to.size() == 1) {
      clocks_->feed(readers.front(), std::move(feeds));
      return;
    }
    const auto branches = clocks_->fork(std::move(feeds), readers, waiting.size(), depth);
    for (std::size_t i = 0; i < branches.size(); ++i) {
      clocks_->feed(waiting_readers[i], {{branches[i], mover<T>(waiting[i], {behind[i]})}});
    }
  }
  template <class Job, class Numbered>
  void clocked_repeat(const std::vector<Out<Job>*>& from, In<Numbered>& to,
                      const Shared<Job>& counted, unsigned depth) {
    struct State {
      Job job;
      std::uint64_t number = 0;
    };
    const auto state = std::make_shared<State>();
    std::vector<Clocks::Feed> feeds;
    for (Out<Job>* out : from) {
      auto queue = std::make_shared<Fifo<Job>>();
      feeds.push_back({clocked_output(*out, queue, depth), [=, numbered = to.queue()] {
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
    clocks_->feed(unit_of(port_name(&to)), std::move(feeds));
  }
  template <class T, unsigned N, unsigned L>
  void clocked_ram(RamWrite<T, N>& writer, const RamRead<T, N, L>& reader,
                   const std::shared_ptr<std::vector<T>>& rows) {
    const auto log = std::make_shared<typename RamWrite<T, N>::Log>();
    writer.record(log.get());
    const std::string written = port_name(&writer);
    const std::string unit = unit_of(port_name(&reader));
    const auto found = std::ranges::find(record_.units, unit, &UnitRecord::name);
    const auto& stages = schedule_.at(found->module).ram_stages;
    const auto stage = stages.find(port_name(&reader).substr(unit.size() + 1));
    clocks_->stale_ram(
        unit_of(written), written.substr(written.find('.') + 1),
        stage == stages.end() ? 0 : stage->second, [log] { return log->size(); },
        [log, rows] {
          (*rows)[log->front().first] = log->front().second;
          log->erase(log->begin());
        });
  }
  static std::string unit_of(const std::string& port) { return port.substr(0, port.find('.')); }
  std::ptrdiff_t inputs_of(const std::string& unit) const {
    const auto found = std::ranges::find(record_.units, unit, &UnitRecord::name);
    return std::ranges::count_if(
        found->ports, [](const PortRecord& port) { return port.type.kind == PortKind::kIn; });
  }

  /// How often a unit can step before it must look at its inputs again.
  template <class U>
  static std::size_t transactions_ready(U& unit) {
    return std::apply([](auto&... port) { return std::min({tokens_ready(port)...}); },
                      unit.hls_fields());
  }
  template <class P>
  static std::size_t tokens_ready(P& port) {
    if constexpr (requires { port.ready(); }) {
      return port.ready();
    } else {
      return std::numeric_limits<std::size_t>::max();
    }
  }

  template <class T>
  static std::vector<FieldRecord> fields_of() {
    std::vector<FieldRecord> fields;
    if constexpr (Struct<T>) {
      const std::vector<std::string> names = split_names(T::hls_field_names());
      unsigned offset = 0;
      const auto add = [&](unsigned width) {
        fields.push_back({names[fields.size()], offset, width});
        offset += width;
      };
      T value{};
      std::apply([&](auto&... field) { (add(bit_width_of<std::decay_t<decltype(field)>>()), ...); },
                 value.hls_fields());
    }
    return fields;
  }

  void add_port(UnitRecord&, const std::string&, Absent&) {}
  template <class P>
  void add_port(UnitRecord& record, const std::string& name, P& port) {
    names_[&port] = record.name + "." + name;
    record.ports.push_back({name, P::kPort});
  }
  const std::string& port_name(const void* port) const {
    const auto found = names_.find(port);
    if (found == names_.end()) {
      throw std::logic_error(
          "a port is connected whose unit is not part of the join, or which the "
          "unit does not name in HLS_PORTS");
    }
    return found->second;
  }
  void count(const ChannelRecord& record, std::function<std::uint64_t()> tokens) {
    record_.channels.push_back(record);
    tokens_.emplace_back(record.name, std::move(tokens));
  }

  JoinRecord record_;
  std::string group_;
  Schedule schedule_;
  std::unique_ptr<Clocks> clocks_;              ///< null: there is no clock
  std::map<std::string, Clocks::Queue*> ends_;  ///< with clocks: inputs and outputs, by channel
  std::deque<Process> processes_;               ///< stays where it is
  std::vector<std::pair<std::string, std::function<std::uint64_t()>>> tokens_;
  std::map<const void*, std::string> names_;
};

}  // namespace hls
