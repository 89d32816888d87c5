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
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "hls/device.h"
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

  /// The names of the next units, channels and RAMs begin with `prefix`.
  void begin_names(const std::string& prefix) { prefix_ = prefix; }

  /// Adds a unit; its Verilog module has the name `module`.
  template <class U>
  void unit(const std::string& name, const std::string& module, U& unit) {
    const UnitCalls calls{
        &unit, [](void* u) { return transactions_ready(*static_cast<U*>(u)); },
        [](void* u, std::size_t transactions) { run_unit(*static_cast<U*>(u), transactions); }};
    std::vector<PortOfUnit> ports;
    for_each_port(unit, [&ports]<class P>(const std::string& port_name, P& port) {
      ports.push_back({port_name, &port, P::kPort});
    });
    add_unit(name, module, calls, ports);
  }

  /// One channel from any of `from` to all of `to`. `depth`, if not 0, promises that the channel
  /// never holds more tokens: its FIFOs hold them all and never refuse one, but those of writers
  /// that are to be short.
  template <class T>
  void channel(const std::string& name, const Writers<T>& from, const Readers<T>& to,
               unsigned depth = 0) {
    add_channel(name, from.ends(), to.ends(), token_type<T>(), depth, from.short_fifos());
  }
  template <class T>
  void channel(const std::string& name, Out<T>& from, In<T>& to, unsigned depth = 0) {
    add_channel(name, {&from}, {&to}, token_type<T>(), depth, {});
  }

  /// Sends every job `job.repeat` + 1 times, numbered from 0.
  template <class Job, class Numbered>
  void repeat(const std::string& name, const Writers<Job>& from, In<Numbered>& to,
              unsigned depth = 0) {
    to.bind(std::make_shared<Fifo<Numbered>>());
    add_repeat(name, from.ends(), to, token_type<Job>(), bit_width_of<decltype(Job::repeat)>(),
               &send_numbered<Job, Numbered>, depth, from.short_fifos());
  }

  /// A channel that the outside writes.
  template <class T>
  std::shared_ptr<Fifo<T>> input(const std::string& name, In<T>& to) {
    return std::static_pointer_cast<Fifo<T>>(add_input(name, to, token_type<T>()));
  }
  /// A channel that the outside reads.
  template <class T>
  std::shared_ptr<Fifo<T>> output(const std::string& name, Out<T>& from) {
    return std::static_pointer_cast<Fifo<T>>(add_output(name, from, token_type<T>()));
  }
  /// Gives the requests of an output to a device, whose answers come to an input, and the writes of
  /// another output if it is named. The device holds the queues, and stays where it is.
  void attach(const std::string& requests, const std::string& answers, Device& device,
              const std::string& writes = {});
  /// A channel whose tokens are counted and dropped.
  template <class T>
  void sink(const std::string& name, Out<T>& from) {
    add_sink(name, from, token_type<T>());
  }

  /// A RAM between units: one writer, a copy for each of `readers`, a container of RamRead<T, N,
  /// L>*. A RAM with read-write collisions (H = kTorn) has one reader, and the lowest field of its
  /// rows, `torn`, marks them.
  template <Hazard H = Hazard::kExclusive, class T, unsigned N>
  void ram(const std::string& name, RamWrite<T, N>& writer, const auto& readers) {
    const Rows<T> rows(N);
    add_ram({prefix_ + name, {}, {}, bit_width_of<T>(), N, H}, &writer,
            bind_readers<N>(readers, rows));
    if constexpr (H == Hazard::kTorn) {
      expect_lowest_field(name, fields_of<T>(), "torn");
      if (clocks_) {
        const auto log = std::make_shared<WriteLog<T>>();
        writer.bind_taker(&log_write<T>, log);
        const auto tear = [log, rows](std::size_t i) { rows[(*log)[i].first].torn = true; };
        const auto land = [log, rows] {
          rows[log->front().first] = log->front().second;
          log->erase(log->begin());
        };
        clocks_->torn_ram(ports_,
                          {&writer, *readers.begin(), [log] { return log->size(); }, tear, land});
        return;
      }
    }
    writer.bind(rows);
  }
  /// A RAM whose rows are written whole and read a word at a time, with the word's number in the
  /// highest bits of the address. One word is written in a clock: the next row must not come before
  /// the last word is written, and a word must not be read before it is written.
  template <class T, std::size_t W, unsigned N>
  void ram_of_words(const std::string& name, RamWrite<std::array<T, W>, N>& writer,
                    const auto& readers) {
    static_assert(W > 1 && std::has_single_bit(N), "an address is word, row");
    const Rows<T> words(W * N);
    add_ram({prefix_ + name, {}, {}, bit_width_of<std::array<T, W>>(), N, Hazard::kExclusive, W},
            &writer, bind_readers<W * N>(readers, words));
    const auto take = [](void* to, std::uint64_t row, const std::array<T, W>& written) {
      for (std::size_t w = 0; w < W; ++w) static_cast<T*>(to)[w * N + row] = written[w];
    };
    writer.bind_taker(take, words.memory());
  }
  /// A reading or writing port that leaves the chip, on a bank that the outside owns.
  template <class T, unsigned N, unsigned L>
  void bank(const std::string& name, RamRead<T, N, L>& reader, Rows<T> rows) {
    reader.bind(std::move(rows));
    record_.banks.push_back({prefix_ + name, ports_.name_of(&reader), bit_width_of<T>(), N, false});
  }
  template <class T, unsigned N>
  void bank(const std::string& name, RamWrite<T, N>& writer, Rows<T> rows) {
    writer.bind(std::move(rows));
    record_.banks.push_back({prefix_ + name, ports_.name_of(&writer), bit_width_of<T>(), N, true});
  }

  /// A value set from outside, seen by all of `ports`.
  template <class T>
  void config(const std::string& name, std::shared_ptr<T> value, std::vector<Config<T>*> ports) {
    ConfigRecord record{prefix_ + name, {}, bit_width_of<T>(), false, 0, fields_of<T>()};
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
  void depends_on_order(const std::vector<std::string>& names);

  /// Says that the top has no counters.
  void leave_out_counters() { record_.counts = false; }

  /// Before a transaction: of the unit at this place in the record's list, in this clock, 0 where
  /// there is none. What it throws comes out of run() or run_clocks().
  using Watch = std::function<void(std::size_t unit, std::uint64_t clock)>;
  /// Watches every transaction from now on, which takes time.
  void watch(Watch watch) { *watch_ = std::move(watch); }

  /// Watches the FIFOs of the next run, if there are clocks, and how long units wait for them.
  /// Units have their places in the record's list, FIFOs theirs in fifos().
  void watch_clocks(ClockWatch& watch) {
    if (clocks_) clocks_->watch(watch);
  }
  /// Those of a join with clocks.
  std::vector<FifoRecord> fifos() const {
    return clocks_ ? clocks_->fifos() : std::vector<FifoRecord>();
  }

  /// Runs every unit until none has work left.
  void run();

  /// The next token that the outside has put into an input comes in this clock, but not before the
  /// previous token. This function and the next ones are only for joins with clocks.
  void arrives(const std::string& input, std::uint64_t clock) { clocks_->arrives(input, clock); }
  /// Runs clock by clock until no token moves any more. Tokens for the outside stay in their
  /// queues.
  void run_clocks() { clocks_->run(); }
  /// The clock in which the outside can take the first token of an output.
  std::uint64_t first_of(const std::string& output) const { return clocks_->first_of(output); }

  /// By their names: transactions of every unit, tokens of every channel, and with clocks the
  /// stalls of every unit.
  std::map<std::string, std::uint64_t> counters() const;

  const JoinRecord& record() const { return record_; }

 private:
  /// Works until an input is empty, and counts; false if there was nothing to do.
  using Run = std::function<bool(std::uint64_t& transactions)>;
  /// A unit of whichever class.
  struct UnitCalls {
    void* self;
    std::size_t (*ready)(void* self);
    void (*run)(void* self, std::size_t transactions);
  };
  struct Process {
    std::string name;  ///< of its unit; empty for parts between units
    std::uint64_t transactions;
    Run run;
  };

  /// Binds ports that read N rows; gives their addresses.
  template <unsigned N, class T>
  static std::vector<const void*> bind_readers(const auto& readers, const Rows<T>& rows) {
    std::vector<const void*> ports;
    for (auto* reader : readers) {
      static_assert(std::remove_pointer_t<decltype(reader)>::kPort.rows == N);
      reader->bind(rows);
      ports.push_back(reader);
    }
    return ports;
  }

  void add_unit(const std::string& name, const std::string& module, UnitCalls unit,
                const std::vector<PortOfUnit>& ports);
  void add_channel(const std::string& name, const std::vector<OutEnd*>& from,
                   const std::vector<InEnd*>& to, TokenType type, unsigned depth,
                   const std::vector<OutEnd*>& short_fifos);
  void add_repeat(const std::string& name, const std::vector<OutEnd*>& from, const InEnd& to,
                  TokenType type, unsigned repeat_width, SendNumbered send, unsigned depth,
                  const std::vector<OutEnd*>& short_fifos);
  std::shared_ptr<TokenQueue> add_input(const std::string& name, InEnd& to, TokenType type);
  std::shared_ptr<TokenQueue> add_output(const std::string& name, OutEnd& from, TokenType type);
  void add_ram(RamRecord record, const void* writer, const std::vector<const void*>& readers);
  void add_sink(const std::string& name, OutEnd& from, TokenType type);
  void count(const ChannelRecord& record, std::function<std::uint64_t()> tokens);

  template <class Job, class Numbered>
  static bool send_numbered(TokenQueue& jobs, std::uint64_t number, TokenQueue& numbered) {
    auto& from = static_cast<Fifo<Job>&>(jobs);
    const Job& job = from.front();
    Numbered token;
    token.job = job;
    token.index = decltype(token.index)::from(number);
    token.last = number == job.repeat.to_u64();
    static_cast<Fifo<Numbered>&>(numbered).push(token);
    if (token.last) from.pop();
    return token.last;
  }

  /// Flattened: `step` and all that it calls is compiled into the loop.
  template <class U>
  [[gnu::flatten]] static void run_unit(U& unit, std::size_t transactions) {
    for (std::size_t i = 0; i < transactions; ++i) unit.step();
  }
  /// How often a unit can step before it must look at its inputs again.
  template <class U>
  static std::size_t transactions_ready(U& unit) {
    return unit.hls_visit([](auto&... port) { return std::min({tokens_ready(port)...}); });
  }
  template <class P>
  static std::size_t tokens_ready(P& port) {
    if constexpr (requires { port.ready(); }) {
      return port.ready();
    } else {
      return std::numeric_limits<std::size_t>::max();
    }
  }
  template <class P, std::size_t N>
  static std::size_t tokens_ready(P (&ports)[N]) {
    std::size_t ready = tokens_ready(ports[0]);
    for (std::size_t i = 1; i < N; ++i) ready = std::min(ready, tokens_ready(ports[i]));
    return ready;
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
      value.hls_visit(
          [&](auto&... field) { (add(bit_width_of<std::decay_t<decltype(field)>>()), ...); });
    }
    return fields;
  }

  /// Throws std::invalid_argument unless the lowest bit of a RAM's rows has this name.
  static void expect_lowest_field(const std::string& ram, const std::vector<FieldRecord>& fields,
                                  const std::string& name) {
    if (!fields.empty() && fields.front().name == name && fields.front().width == 1) return;
    throw std::invalid_argument("join: rows of the RAM '" + ram + "' may be torn; make the bit '" +
                                name + "' the first of their fields");
  }

  JoinRecord record_;
  std::unique_ptr<Watch> watch_ = std::make_unique<Watch>();  ///< units know where it is
  std::string group_, prefix_;
  JoinPorts ports_;
  std::unique_ptr<JoinClocks> clocks_;                          ///< null: there is no clock
  std::deque<Process> processes_;                               ///< elements keep their addresses
  std::map<std::string, std::shared_ptr<TokenQueue>> outputs_;  ///< those that the outside reads
  std::vector<std::pair<std::string, std::function<std::uint64_t()>>> tokens_;
};

}  // namespace hls
