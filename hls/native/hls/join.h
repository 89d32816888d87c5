// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The one description of how units are joined. A join connects the ports of native units so that
// they run as the model, and records the connections, from which hls/compiler/join makes the
// Verilog top and the block diagram. An arbiter merges several writers of a channel, several
// readers are fed by a fork, a job channel is repeated, a RAM with several readers has a copy for
// each. A join that knows the units' schedules runs them clock by clock (clocks.h), slower but with
// the same results.
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

#include "hls/join_clocks.h"
#include "hls/join_ports.h"
#include "hls/join_record.h"
#include "hls/ports.h"

namespace hls {

class Join {
 public:
  Join() = default;
  /// Units run clock by clock, by these schedules. Throws std::invalid_argument, here or when a
  /// unit is added, if a schedule is missing.
  explicit Join(ModuleSchedules schedules)
      : clocks_(std::make_unique<JoinClocks>(std::move(schedules))) {}

  /// Block diagrams show the next units under this name.
  void group(const std::string& name) { group_ = name; }

  /// Adds a unit; its Verilog module has the name `module`.
  template <class U>
  void unit(const std::string& name, const std::string& module, U& unit) {
    UnitRecord record{name, module, {}, group_};
    ports_.add(record, unit);
    record_.units.push_back(std::move(record));
    processes_.push_back(
        {name, 0, [&unit](std::uint64_t& transactions) { return run_unit(unit, transactions); }});
    if (clocks_) {
      clocks_->unit(name, module,
                    [&process = processes_.back()] { process.run(process.transactions); });
    }
  }

  /// One channel from any of `from` to all of `to`. `depth`, if not 0, promises that the channel
  /// never holds more tokens: its FIFOs hold them all and never refuse one.
  template <class T>
  void channel(const std::string& name, std::vector<Out<T>*> from, std::vector<In<T>*> to,
               unsigned depth = 0) {
    ChannelRecord record{name, {}, {}, bit_width_of<T>(), depth, ChannelKind::kChannel};
    for (In<T>* in : to) {
      record.to.push_back(ports_.name_of(in));
      in->bind(std::make_shared<Fifo<T>>());
    }
    for (Out<T>* out : from) record.from.push_back(ports_.name_of(out));
    if (clocks_) {
      clocks_->channel(ports_, from, to, depth);
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
        name, {}, {ports_.name_of(&to)}, bit_width_of<Job>(), depth, ChannelKind::kRepeat};
    record.repeat_width = bit_width_of<decltype(Job::repeat)>();
    for (Out<Job>* out : from) record.from.push_back(ports_.name_of(out));
    if (clocks_) {
      clocks_->repeat(ports_, from, to, jobs, depth);
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
        {name, {}, {ports_.name_of(&to)}, bit_width_of<T>(), 0, ChannelKind::kInput});
    return clocks_ ? clocks_->input(ports_, name, to) : to.queue();
  }
  /// A channel that the outside reads.
  template <class T>
  std::shared_ptr<Fifo<T>> output(const std::string& name, Out<T>& from) {
    auto queue = std::make_shared<Fifo<T>>();
    record_.channels.push_back(
        {name, {ports_.name_of(&from)}, {}, bit_width_of<T>(), 0, ChannelKind::kOutput});
    if (clocks_) {
      clocks_->output(ports_, name, from, queue);
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
      clocks_->sink(ports_, from, queue);
    } else {
      from.bind(queue);
      processes_.push_back({"", 0, [queue](std::uint64_t&) {
                              while (!queue->empty()) queue->pop();
                              return false;
                            }});
    }
    ChannelRecord record{name, {ports_.name_of(&from)}, {}, bit_width_of<T>(),
                         0,    ChannelKind::kSink};
    count(record, [queue] { return queue->pushed(); });
  }

  /// A RAM between units: one writer, a copy for each reader.
  template <class T, unsigned N, unsigned L>
  void ram(const std::string& name, RamWrite<T, N>& writer, std::vector<RamRead<T, N, L>*> readers,
           Hazard hazard = Hazard::kExclusive) {
    RamRecord record{name, ports_.name_of(&writer), {}, bit_width_of<T>(), N, hazard};
    auto rows = std::make_shared<std::vector<T>>(N);
    if (clocks_ && hazard == Hazard::kStale) {
      clocks_->stale_ram(ports_, writer, *readers.at(0), rows);
    } else {
      writer.bind(rows);
    }
    for (auto* reader : readers) {
      record.readers.push_back(ports_.name_of(reader));
      reader->bind(rows);
    }
    record_.rams.push_back(std::move(record));
  }
  /// A RAM whose rows are written whole and read a word at a time, with the word's number in the
  /// highest bits of the address. One word is written in a clock: the next row must not come before
  /// the last word is written, and a word must not be read before it is written.
  template <class T, std::size_t W, unsigned N, unsigned M, unsigned L>
  void ram_of_words(const std::string& name, RamWrite<std::array<T, W>, N>& writer,
                    std::vector<RamRead<T, M, L>*> readers) {
    static_assert(W > 1 && M == W * N && std::has_single_bit(N), "an address is word, row");
    RamRecord record{name, ports_.name_of(&writer), {}, bit_width_of<std::array<T, W>>(),
                     N,    Hazard::kExclusive,      W};
    auto words = std::make_shared<std::vector<T>>(M);
    writer.bind([words](std::uint64_t row, const std::array<T, W>& written) {
      for (std::size_t w = 0; w < W; ++w) (*words)[w * N + row] = written[w];
    });
    for (auto* reader : readers) {
      record.readers.push_back(ports_.name_of(reader));
      reader->bind(words);
    }
    record_.rams.push_back(std::move(record));
  }
  /// A reading or writing port that leaves the chip, on a bank that the outside owns.
  template <class T, unsigned N, unsigned L>
  void bank(const std::string& name, RamRead<T, N, L>& reader,
            std::shared_ptr<std::vector<T>> rows) {
    reader.bind(std::move(rows));
    record_.banks.push_back({name, ports_.name_of(&reader), bit_width_of<T>(), N, false});
  }
  template <class T, unsigned N>
  void bank(const std::string& name, RamWrite<T, N>& writer, std::shared_ptr<std::vector<T>> rows) {
    writer.bind(std::move(rows));
    record_.banks.push_back({name, ports_.name_of(&writer), bit_width_of<T>(), N, true});
  }

  /// A value set from outside, seen by all of `ports`.
  template <class T>
  void config(const std::string& name, std::shared_ptr<T> value, std::vector<Config<T>*> ports) {
    ConfigRecord record{name, {}, bit_width_of<T>(), false, 0, fields_of<T>()};
    for (Config<T>* port : ports) {
      record.to.push_back(ports_.name_of(port));
      port->bind(value);
    }
    record_.configs.push_back(std::move(record));
  }
  /// A value fixed for one port.
  template <class T>
  void constant(Config<T>& port, T value) {
    port.bind(std::make_shared<T>(value));
    record_.configs.push_back(
        {"", {ports_.name_of(&port)}, bit_width_of<T>(), true, leaf_to_bits(value).to_u64()});
  }

  /// Marks channels and units, by name, whose counts depend on the order in which tokens are
  /// served: two runs of the same work may count differently there.
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

  /// The next token that the outside has put into an input comes in this clock, but not before the
  /// previous token. This function and the next ones are only for joins with clocks.
  void arrives(const std::string& input, std::uint64_t clock) { clocks_->arrives(input, clock); }
  /// Runs clock by clock until no token moves any more. Tokens for the outside stay in their
  /// queues.
  void run_clocks() { clocks_->run(); }
  /// The clock in which the outside can take the first token of an output.
  std::uint64_t first_of(const std::string& output) const { return clocks_->first_of(output); }

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

  void count(const ChannelRecord& record, std::function<std::uint64_t()> tokens) {
    record_.channels.push_back(record);
    tokens_.emplace_back(record.name, std::move(tokens));
  }

  JoinRecord record_;
  std::string group_;
  JoinPorts ports_;
  std::unique_ptr<JoinClocks> clocks_;  ///< null: there is no clock
  std::deque<Process> processes_;       ///< elements keep their addresses
  std::vector<std::pair<std::string, std::function<std::uint64_t()>>> tokens_;
};

}  // namespace hls
