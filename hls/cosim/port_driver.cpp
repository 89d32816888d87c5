// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "cosim/port_driver.h"

#include <fmt/format.h>

#include <deque>
#include <stdexcept>
#include <utility>

namespace hls::cosim {

void PortDriver::compare(const std::string& what, const TokenBits& rtl, const TokenBits& model,
                         std::uint64_t transaction) {
  ++compared_;
  if (rtl == model) return;
  if (const auto difference = model_.difference(rtl, model)) {
    throw Mismatch(
        fmt::format("port {}, {} {}: field {}: RTL {}, model {}", name(), what, compared_ - 1,
                    difference->field, difference->left, difference->right),
        transaction);
  }
}

namespace {

class InDriver : public PortDriver {
 public:
  InDriver(ModelPort& model, const PortPins& pins)
      : PortDriver(model, pins), next_(zero_bits(pins.type.width)) {}
  void draw(Random& random) override { redraw(next_, random); }
  std::optional<std::uint64_t> packet() const override {
    return packet_of ? std::optional(packet_of(next_)) : std::nullopt;
  }
  void commit(std::uint64_t transaction) override {
    model_.give(next_);
    pending_.emplace_back(transaction, next_);
    history_.emplace_back(transaction, next_);
    if (begun) begun(next_);
    if (history_.size() > kHistory) history_.pop_front();
  }
  std::size_t backlog() const override { return pending_.size(); }
  std::string describe(std::uint64_t transaction) const override {
    for (const auto& [number, token] : history_) {
      if (number == transaction) return fmt::format("{}: {}", name(), model_.describe(token));
    }
    return {};
  }
  void drive(Random& random, bool stall) override {
    valid_ = valid_ || (!pending_.empty() && !stall);
    pins_.valid.set(valid_);
    if (valid_) {
      put(pending_.front().second);
    } else {
      put_garbage(random);
    }
  }
  void observe(Ledger&) override { moved_ = valid_ && pins_.ready.get() != 0; }
  void edge(Ledger& ledger) override {
    if (!moved_) return;
    ledger.accepted(pending_.front().first);
    pending_.pop_front();
    valid_ = false;
  }
  std::string waiting() const override {
    return valid_ ? fmt::format("{} is not taken", name()) : std::string{};
  }

 private:
  static constexpr std::size_t kHistory = 1024;
  TokenBits next_;
  std::deque<std::pair<std::uint64_t, TokenBits>> pending_;
  std::deque<std::pair<std::uint64_t, TokenBits>> history_;
  bool valid_ = false;
};

class OutDriver : public PortDriver {
 public:
  using PortDriver::PortDriver;
  void collect(std::uint64_t transaction, Ledger& ledger) override {
    while (auto token = model_.take()) {
      expected_.emplace_back(transaction, std::move(*token));
      ledger.expect(transaction);
    }
  }
  void drive(Random&, bool stall) override {
    ready_ = !stall;
    pins_.ready.set(ready_);
  }
  void observe(Ledger& ledger) override {
    const bool valid = pins_.valid.get() != 0;
    const TokenBits token = get();
    if (held_up_ && !valid) {
      throw Mismatch(fmt::format("port {}: valid fell before ready came", name()));
    }
    if (held_up_ && token != held_) {
      throw Mismatch(fmt::format("port {}: the token changed before ready came, to {}", name(),
                                 model_.describe(token)));
    }
    held_up_ = valid && !ready_;
    held_ = token;
    moved_ = valid && ready_;
    if (!moved_) return;
    if (expected_.empty()) {
      throw Mismatch(fmt::format("port {}: RTL gives a token that the model does not give: {}",
                                 name(), model_.describe(token)));
    }
    compare("token", token, expected_.front().second, expected_.front().first);
    ledger.seen(expected_.front().first);
    expected_.pop_front();
  }
  std::string waiting() const override {
    if (expected_.empty()) return {};
    return fmt::format("{} has not given token {} of transaction {}: {}", name(), compared_,
                       expected_.front().first, model_.describe(expected_.front().second));
  }

 private:
  std::deque<std::pair<std::uint64_t, TokenBits>> expected_;
  TokenBits held_;
  bool ready_ = false;
};

/// A RAM of another unit, whose contents do not change. The data of an address are on the pins in
/// one clock only, `latency` clocks after it.
class RamReadDriver : public PortDriver {
 public:
  RamReadDriver(ModelPort& model, const PortPins& pins)
      : PortDriver(model, pins), rows_(pins.type.rows, zero_bits(pins.type.width)) {}
  void prepare(Random& random) override {
    for (std::uint64_t i = 0; i < rows_.size(); ++i) {
      redraw(rows_[i], random);
      model_.give_row(i, rows_[i]);
    }
  }
  void drive(Random& random, bool) override {
    if (due_.size() == pins_.type.latency && due_.front()) {
      put(rows_[*due_.front()]);
    } else {
      put_garbage(random);
    }
  }
  void observe(Ledger&) override {
    moved_ = pins_.enable.get() != 0;
    address_ = pins_.address.get();
    if (moved_ && address_ >= rows_.size()) {
      throw Mismatch(
          fmt::format("port {}: RTL reads row {} of {}", name(), address_, rows_.size()));
    }
  }
  void edge(Ledger&) override {
    due_.push_back(moved_ ? std::optional(address_) : std::nullopt);
    if (due_.size() > pins_.type.latency) due_.pop_front();
  }

 private:
  std::vector<TokenBits> rows_;
  std::deque<std::optional<std::uint64_t>> due_;
  std::uint64_t address_ = 0;
};

class RamWriteDriver : public PortDriver {
 public:
  using PortDriver::PortDriver;
  void collect(std::uint64_t transaction, Ledger& ledger) override {
    while (auto write = model_.take_write()) {
      expected_.emplace_back(transaction, std::move(*write));
      ledger.expect(transaction);
    }
  }
  void observe(Ledger& ledger) override {
    moved_ = pins_.enable.get() != 0;
    if (!moved_) return;
    const std::uint64_t address = pins_.address.get();
    const TokenBits row = get();
    if (expected_.empty()) {
      throw Mismatch(fmt::format("port {}: RTL writes row {}, the model writes none: {}", name(),
                                 address, model_.describe(row)));
    }
    const auto& [transaction, write] = expected_.front();
    if (address != write.address) {
      throw Mismatch(fmt::format("port {}, write {}: RTL writes row {}, the model row {}", name(),
                                 compared_, address, write.address),
                     transaction);
    }
    compare("write", row, write.row, transaction);
    ledger.seen(transaction);
    expected_.pop_front();
  }
  std::string waiting() const override {
    if (expected_.empty()) return {};
    const auto& [transaction, write] = expected_.front();
    return fmt::format("{} has not made write {} of transaction {}: row {}: {}", name(), compared_,
                       transaction, write.address, model_.describe(write.row));
  }

 private:
  std::deque<std::pair<std::uint64_t, RowWrite>> expected_;
};

class ConfigDriver : public PortDriver {
 public:
  using PortDriver::PortDriver;
  void prepare(Random& random) override {
    TokenBits value = zero_bits(pins_.type.width);
    redraw(value, random);
    model_.give(value);
    put(value);
  }
};

}  // namespace

std::unique_ptr<PortDriver> make_driver(ModelPort& model, const PortPins& pins) {
  switch (model.type().kind) {
    case PortKind::kIn:
      return std::make_unique<InDriver>(model, pins);
    case PortKind::kOut:
      return std::make_unique<OutDriver>(model, pins);
    case PortKind::kRamRead:
      return std::make_unique<RamReadDriver>(model, pins);
    case PortKind::kRamWrite:
      return std::make_unique<RamWriteDriver>(model, pins);
    case PortKind::kConfig:
      return std::make_unique<ConfigDriver>(model, pins);
    case PortKind::kRam:
    case PortKind::kRegisterFile:
      break;
  }
  throw std::logic_error("the RAM " + model.name() + " lies inside its unit and has no pins");
}

}  // namespace hls::cosim
