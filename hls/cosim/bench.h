// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Co-simulation of one unit: the same random and extreme tokens go to a model and to the Verilated
// unit, both ends of every channel stall at random, and every token and every row written outside
// is compared, in order, to the last bit. The model is the native unit:
//
//     Vmailbox dut;
//     hls::cosim::Bench<dynrt::Mailbox<C>> bench("mailbox", dut, [](auto& v, auto& f) {
//       visit_ports_mailbox(v, f);               // from mailbox_ports.h, which hlsc wrote
//     });
//     bench.packet<Entry>("entry", [](const Entry& e) { return e.packet.to_u64(); });
//     const hls::cosim::Report report = bench.run({.transactions = 20'000});
//     EXPECT_TRUE(report.ok) << report.text;
//
// or any other (ModelBench). The packet rule: with `packet` set, a packet has at most one
// transaction in the unit at a time. The seed is printed; the environment's HLS_SEED overrides it.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cosim/ledger.h"
#include "cosim/model.h"
#include "cosim/native_model.h"
#include "cosim/pins.h"
#include "cosim/port_driver.h"

namespace hls::cosim {

struct Settings {
  std::uint64_t seed = 1;
  std::uint64_t transactions = 10'000;
  bool stall_inputs = true;    ///< false: a waiting token is always offered
  bool stall_outputs = true;   ///< false: outputs are always ready
  unsigned patience = 5'000;   ///< clocks without any progress that count as a deadlock
  unsigned reset_clocks = 64;  ///< at least the rows of the largest register file, which it clears
  unsigned drain = 200;        ///< more clocks than the unit has stages
  unsigned return_clocks = 2;  ///< least clocks from a packet's leaving to its coming back
  /// For waveforms: called after every eval.
  std::function<void(std::uint64_t half_clock)> dump = {};
};

struct Report {
  bool ok = false;
  std::string text;  ///< a summary of the run, or its first mistake
  std::uint64_t transactions = 0;
  std::uint64_t compared = 0;  ///< tokens and rows
  std::uint64_t clocks = 0;    ///< from the first transaction to the last comparison
};

/// The bench with any model.
class ModelBench {
 public:
  template <class Dut, class Visit>
  ModelBench(std::string name, Dut& dut, Visit visit, std::unique_ptr<Model> model)
      : name_(std::move(name)), model_(std::move(model)) {
    visit(dut, pins_);
    eval_ = [&dut] { dut.eval(); };
    for (const auto& port : model_->ports()) {
      ports_.push_back(make_driver(*port, take(port->name(), port->type())));
      if (port->type().kind == PortKind::kIn) ++inputs_;
    }
    for (const auto& [port, pins] : pins_.ports) {
      throw std::logic_error(
          fmt::format("{}: the Verilog has a port {}, the unit has none", name_, port));
    }
  }

  /// Changes every random token (row, value) of a port.
  template <class T>
  void shape(const std::string& port, std::function<void(T&, Random&)> function) {
    find<PortDriver, T>(port).shape = [function = std::move(function)](TokenBits& bits,
                                                                       Random& random) {
      if constexpr (std::is_same_v<T, TokenBits>) {
        function(bits, random);
      } else {
        T token = from_bits<T>(bits);
        function(token, random);
        bits = cosim::to_bits(token);
      }
    };
  }
  /// Tells the bench the packet of an In's token.
  template <class T>
  void packet(const std::string& port, std::function<std::uint64_t(const T&)> function) {
    find<InDriver, T>(port).packet_of = [function = std::move(function)](const TokenBits& bits) {
      return function(from_bits<T>(bits));
    };
  }
  /// Called with every token with which a transaction begins; a token that was only drawn may be
  /// drawn again.
  template <class T>
  void begun(const std::string& port, std::function<void(const T&)> function) {
    find<InDriver, T>(port).begun = [function = std::move(function)](const TokenBits& bits) {
      function(from_bits<T>(bits));
    };
  }
  /// An output that random tokens need not reach; every other output must give at least one token.
  void may_be_silent(const std::string& port) { silent_.insert(port); }

  /// Call it once for each bench, as the unit keeps its state.
  Report run(Settings settings) {
    if (const char* seed = std::getenv("HLS_SEED")) settings.seed = std::strtoull(seed, nullptr, 0);
    Report report;
    Random random(settings.seed);
    Ledger ledger(settings.drain, settings.return_clocks);
    std::uint64_t clock = 0;
    try {
      reset(random, settings);
      clock = simulate(random, ledger, settings);
      report.ok = true;
    } catch (const Mismatch& mismatch) {
      report.text = mismatch.what();
      for (const auto& port : ports_) {
        if (!mismatch.transaction) break;
        const std::string token = port->describe(*mismatch.transaction);
        if (!token.empty()) {
          report.text += fmt::format("\n  transaction {} read {}", *mismatch.transaction, token);
        }
      }
    }
    report.transactions = ledger.begun();
    for (const auto& port : ports_) report.compared += port->compared();
    report.clocks = clock;
    const std::string run =
        fmt::format("{}: seed {}, {} transactions, {} tokens and rows compared, {} clocks", name_,
                    settings.seed, report.transactions, report.compared, half_clocks_ / 2);
    fmt::print("{}\n", run);
    report.text = report.ok ? run : fmt::format("{}\n{}", run, report.text);
    return report;
  }

 private:
  /// The pins of a port, which must have the model's kind and width.
  PortPins take(const std::string& name, const PortInfo& type) {
    const auto found = pins_.ports.find(name);
    if (found == pins_.ports.end()) {
      throw std::logic_error(fmt::format("{}: the Verilog has no port {}", name_, name));
    }
    const PortPins pins = found->second;
    if (pins.type != type) {
      throw std::logic_error(fmt::format(
          "{}: port {} is {} bits, {} rows, latency {} in Verilog, {} bits, {} rows, latency {} in "
          "the model",
          name_, name, pins.type.width, pins.type.rows, pins.type.latency, type.width, type.rows,
          type.latency));
    }
    pins_.ports.erase(found);
    return pins;
  }
  template <class Driver, class T>
  Driver& find(const std::string& name) {
    for (const auto& port : ports_) {
      if (port->name() != name) continue;
      auto* driver = dynamic_cast<Driver*>(port.get());
      if (driver && port->model().token_type() == typeid(T)) return *driver;
      throw std::logic_error(fmt::format("{}: port {} has another token", name_, name));
    }
    throw std::logic_error(fmt::format("{}: there is no port {}", name_, name));
  }

  void half_clock(bool high, const Settings& settings) {
    pins_.clk.set(high);
    eval_();
    if (settings.dump) settings.dump(half_clocks_);
    ++half_clocks_;
  }
  void reset(Random& random, const Settings& settings) {
    for (const auto& port : ports_) port->prepare(random);
    for (const auto& port : ports_) port->drive(random, true);
    pins_.rst_n.set(0);
    for (unsigned i = 0; i < settings.reset_clocks; ++i) {
      half_clock(false, settings);
      half_clock(true, settings);
    }
    pins_.rst_n.set(1);
  }

  /// Draws tokens until their packet is not under way, runs the model on them and hands them to
  /// the bench's ports.
  bool begin_transaction(Random& random, Ledger& ledger) {
    for (int attempt = 0; attempt < 8; ++attempt) {
      std::optional<std::uint64_t> packet;
      for (const auto& port : ports_) {
        port->draw(random);
        if (const auto held = port->packet()) packet = held;
      }
      if (packet && ledger.holds(*packet)) continue;
      const std::uint64_t transaction = ledger.begin(inputs_, packet);
      for (const auto& port : ports_) port->commit(transaction);
      model_->step();
      for (const auto& port : ports_) port->collect(transaction, ledger);
      return true;
    }
    return false;
  }

  /// Runs all transactions; returns the clocks until the last comparison.
  std::uint64_t simulate(Random& random, Ledger& ledger, const Settings& settings) {
    constexpr double kStalls[] = {0, 0, 0.1, 0.5, 0.9};
    constexpr std::size_t kBacklog = 4;
    std::vector<double> stall(ports_.size(), 0.0);
    std::uint64_t last_progress = 0;
    std::uint64_t after_last = 0;
    std::uint64_t clock = 0;
    for (; after_last < settings.drain; ++clock) {
      if (clock % 256 == 0) {
        for (std::size_t i = 0; i < stall.size(); ++i) {
          const bool reads = ports_[i]->kind() == PortKind::kIn;
          const bool may_stall = reads ? settings.stall_inputs : settings.stall_outputs;
          if (may_stall) stall[i] = kStalls[random.below(std::size(kStalls))];
        }
      }
      bool progress = false;
      bool room = ledger.begun() < settings.transactions;
      for (const auto& port : ports_) room = room && port->backlog() < kBacklog;
      if (room) progress = begin_transaction(random, ledger);

      for (std::size_t i = 0; i < ports_.size(); ++i) {
        ports_[i]->drive(random, random.chance(stall[i]));
      }
      half_clock(false, settings);
      bool free = true;
      for (const auto& port : ports_) {
        port->observe(ledger);
        progress = progress || port->moved();
        free = free && !port->held_up();
      }
      half_clock(true, settings);
      for (const auto& port : ports_) port->edge(ledger);
      ledger.tick(free);

      if (progress) last_progress = clock;
      const bool finished = ledger.begun() == settings.transactions && ledger.idle();
      after_last = finished ? after_last + 1 : 0;
      if (!finished && clock - last_progress >= settings.patience) throw Mismatch(stuck(settings));
    }
    check_coverage(settings);
    return last_progress + 1;
  }
  std::string stuck(const Settings& settings) const {
    std::string text = fmt::format("no token moved for {} clocks", settings.patience);
    for (const auto& port : ports_) {
      if (const std::string waits = port->waiting(); !waits.empty()) text += "; port " + waits;
    }
    return text;
  }
  void check_coverage(const Settings& settings) const {
    std::uint64_t compared = 0;
    for (const auto& port : ports_) {
      compared += port->compared();
      const bool writes = port->kind() == PortKind::kOut || port->kind() == PortKind::kRamWrite;
      if (writes && port->compared() == 0 && !silent_.contains(port->name())) {
        throw Mismatch(fmt::format("port {} gave no token in {} transactions: no token reaches it",
                                   port->name(), settings.transactions));
      }
    }
    if (compared == 0) throw Mismatch("no token was compared");
  }

  std::string name_;
  UnitPins pins_;
  std::function<void()> eval_;
  std::unique_ptr<Model> model_;
  std::vector<std::unique_ptr<PortDriver>> ports_;
  unsigned inputs_ = 0;
  std::set<std::string> silent_;
  std::uint64_t half_clocks_ = 0;
};

/// The bench of a unit's Verilog and its C++.
template <class Unit>
class Bench : public ModelBench {
 public:
  template <class Dut, class Visit>
  Bench(std::string name, Dut& dut, Visit visit)
      : ModelBench(std::move(name), dut, visit, std::make_unique<NativeModel<Unit>>()) {}
};

}  // namespace hls::cosim
