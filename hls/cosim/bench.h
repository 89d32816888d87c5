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

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <typeindex>
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
    make_drivers();
  }

  /// Changes every random token (row, value) of a port.
  template <class T>
  void shape(const std::string& port, std::function<void(T&, Random&)> function) {
    find(port, typeid(T)).shape = [function = std::move(function)](TokenBits& bits,
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
    find_in(port, typeid(T)).packet_of = [function = std::move(function)](const TokenBits& bits) {
      return function(from_bits<T>(bits));
    };
  }
  /// Called with every token with which a transaction begins; a token that was only drawn may be
  /// drawn again.
  template <class T>
  void begun(const std::string& port, std::function<void(const T&)> function) {
    find_in(port, typeid(T)).begun = [function = std::move(function)](const TokenBits& bits) {
      function(from_bits<T>(bits));
    };
  }
  /// An output that random tokens need not reach; every other output must give at least one token.
  void may_be_silent(const std::string& port) { silent_.insert(port); }

  /// Call it once for each bench, as the unit keeps its state.
  Report run(Settings settings);

 private:
  void make_drivers();
  /// The pins of a port, which must have the model's kind and width.
  PortPins take(const std::string& name, const PortInfo& type);
  PortDriver& find(const std::string& port, std::type_index token);
  PortDriver& find_in(const std::string& port, std::type_index token);
  void half_clock(bool high, const Settings& settings);
  void reset(Random& random, const Settings& settings);

  /// Draws tokens until their packet is not under way, runs the model on them and hands them to
  /// the bench's ports.
  bool begin_transaction(Random& random, Ledger& ledger);

  /// Runs all transactions; returns the clocks until the last comparison.
  std::uint64_t simulate(Random& random, Ledger& ledger, const Settings& settings);
  std::string stuck(const Settings& settings) const;
  void check_coverage(const Settings& settings) const;

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
