// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "cosim/bench.h"

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace hls::cosim {

void ModelBench::make_drivers() {
  for (const auto& port : model_->ports()) {
    ports_.push_back(make_driver(*port, take(port->name(), port->type())));
    if (port->type().kind == PortKind::kIn) ++inputs_;
  }
  for (const auto& [port, pins] : pins_.ports) {
    throw std::logic_error(
        fmt::format("{}: the Verilog has a port {}, the unit has none", name_, port));
  }
}

PortDriver& ModelBench::find(const std::string& name, std::type_index token) {
  for (const auto& port : ports_) {
    if (port->name() != name) continue;
    if (port->model().token_type() == token) return *port;
    throw std::logic_error(fmt::format("{}: port {} has another token", name_, name));
  }
  throw std::logic_error(fmt::format("{}: there is no port {}", name_, name));
}
PortDriver& ModelBench::find_in(const std::string& name, std::type_index token) {
  PortDriver& port = find(name, token);
  if (port.kind() == PortKind::kIn) return port;
  throw std::logic_error(fmt::format("{}: port {} is no In", name_, name));
}

Report ModelBench::run(Settings settings) {
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

PortPins ModelBench::take(const std::string& name, const PortInfo& type) {
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

void ModelBench::half_clock(bool high, const Settings& settings) {
  pins_.clk.set(high);
  eval_();
  if (settings.dump) settings.dump(half_clocks_);
  ++half_clocks_;
}

void ModelBench::reset(Random& random, const Settings& settings) {
  for (const auto& port : ports_) port->prepare(random);
  for (const auto& port : ports_) port->drive(random, true);
  pins_.rst_n.set(0);
  for (unsigned i = 0; i < settings.reset_clocks; ++i) {
    half_clock(false, settings);
    half_clock(true, settings);
  }
  pins_.rst_n.set(1);
}

bool ModelBench::begin_transaction(Random& random, Ledger& ledger) {
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

std::uint64_t ModelBench::simulate(Random& random, Ledger& ledger, const Settings& settings) {
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

std::string ModelBench::stuck(const Settings& settings) const {
  std::string text = fmt::format("no token moved for {} clocks", settings.patience);
  for (const auto& port : ports_) {
    if (const std::string waits = port->waiting(); !waits.empty()) text += "; port " + waits;
  }
  return text;
}

void ModelBench::check_coverage(const Settings& settings) const {
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

}  // namespace hls::cosim
