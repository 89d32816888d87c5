// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The bench's end of every kind of port: it drives the pins of the Verilated unit, binds the same
// port of the native unit, and compares what the two give, in order.
#pragma once

#include <fmt/format.h>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cosim/ledger.h"
#include "cosim/pins.h"
#include "hls/bits.h"
#include "hls/ports.h"
#include "hls/random.h"

namespace dynrt::cosim {

using hls::testing::Random;

/// The Verilated unit does not do what the native one does.
struct Mismatch : std::runtime_error {
  Mismatch(const std::string& text, std::optional<std::uint64_t> in = std::nullopt)
      : std::runtime_error(text), transaction(in) {}
  std::optional<std::uint64_t> transaction;
};

/// What the bench does with every port, whatever its kind and token.
class PortModel {
 public:
  PortModel(std::string name, PortPins pins) : name_(std::move(name)), pins_(pins) {}
  virtual ~PortModel() = default;
  const std::string& name() const { return name_; }
  PortKind kind() const { return pins_.kind; }

  /// Before the run: contents of RAMs and configuration.
  virtual void prepare(Random&) {}
  /// In ports: draws the next transaction's token, and hands it to both units.
  virtual void draw(Random&) {}
  virtual std::optional<std::uint64_t> packet() const { return std::nullopt; }
  virtual void commit(std::uint64_t) {}
  virtual std::size_t backlog() const { return 0; }
  virtual std::string describe(std::uint64_t) const { return {}; }
  /// Ports that write: takes over what the native unit wrote in a transaction.
  virtual void collect(std::uint64_t, Ledger&) {}
  /// One clock: set the unit's inputs; look at its outputs; the edge has come.
  virtual void drive(Random&, bool /*stall*/) {}
  virtual void observe(Ledger&) {}
  virtual void edge(Ledger&) {}

  bool moved() const { return moved_; }      ///< something passed in this clock
  bool held_up() const { return held_up_; }  ///< an output that is offered but not taken
  std::uint64_t compared() const { return compared_; }
  /// What it still waits for, or nothing.
  virtual std::string waiting() const { return {}; }

 protected:
  /// A description of one token or row for messages, and its comparison.
  template <class T>
  void compare(const std::string& what, const T& rtl, const T& model, std::uint64_t transaction) {
    ++compared_;
    if (const auto difference = hls::first_difference(rtl, model)) {
      throw Mismatch(
          fmt::format("port {}, {} {}: field {}: RTL {}, model {}", name_, what, compared_ - 1,
                      difference->field, difference->left, difference->right),
          transaction);
    }
  }
  template <class T>
  T get() const {
    hls::Words<T> words;
    pins_.data.get_words(words.data(), words.size());
    return hls::unpack<T>(words);
  }
  template <class T>
  void put(const T& token) {
    const hls::Words<T> words = hls::pack(token);
    pins_.data.set_words(words.data(), words.size());
  }
  /// Where nothing is promised the unit must not care.
  template <class T>
  void put_garbage(Random& random) {
    T garbage{};
    hls::for_each_leaf(garbage, [&random]<class L>(L& leaf, unsigned) {
      leaf = hls::leaf_from_bits<L>(hls::uint<hls::bit_width_of<L>()>::from(random.next()));
    });
    put(garbage);
  }

  std::string name_;
  PortPins pins_;
  bool moved_ = false;
  bool held_up_ = false;
  std::uint64_t compared_ = 0;
};

/// A port whose values the bench draws: the user may shape them.
template <class T>
class Drawn {
 public:
  std::function<void(T&, Random&)> shape;

 protected:
  void draw_value(T& value, Random& random) {
    hls::testing::randomise(value, random);
    if (shape) shape(value, random);
  }
};

template <class T>
class InPort : public PortModel, public Drawn<T> {
 public:
  std::function<std::uint64_t(const T&)> packet_of;
  std::function<void(const T&)> begun;

  InPort(std::string name, PortPins pins, hls::In<T>& native)
      : PortModel(std::move(name), pins), native_(std::make_shared<hls::Fifo<T>>()) {
    native.bind(native_);
  }
  void draw(Random& random) override { this->draw_value(next_, random); }
  std::optional<std::uint64_t> packet() const override {
    return packet_of ? std::optional(packet_of(next_)) : std::nullopt;
  }
  void commit(std::uint64_t transaction) override {
    native_->push(next_);
    pending_.emplace_back(transaction, next_);
    history_.emplace_back(transaction, next_);
    if (begun) begun(next_);
    if (history_.size() > kHistory) history_.pop_front();
  }
  std::size_t backlog() const override { return pending_.size(); }
  std::string describe(std::uint64_t transaction) const override {
    for (const auto& [number, token] : history_) {
      if (number == transaction) return fmt::format("{}: {}", name_, hls::describe(token));
    }
    return {};
  }
  void drive(Random& random, bool stall) override {
    valid_ = valid_ || (!pending_.empty() && !stall);
    pins_.valid.set(valid_);
    if (valid_) {
      put(pending_.front().second);
    } else {
      put_garbage<T>(random);
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
    return valid_ ? fmt::format("{} is not taken", name_) : std::string{};
  }

 private:
  static constexpr std::size_t kHistory = 1024;
  std::shared_ptr<hls::Fifo<T>> native_;
  T next_{};
  std::deque<std::pair<std::uint64_t, T>> pending_;
  std::deque<std::pair<std::uint64_t, T>> history_;
  bool valid_ = false;
};

template <class T>
class OutPort : public PortModel {
 public:
  OutPort(std::string name, PortPins pins, hls::Out<T>& native)
      : PortModel(std::move(name), pins), native_(std::make_shared<hls::Fifo<T>>()) {
    native.bind(native_);
  }
  void collect(std::uint64_t transaction, Ledger& ledger) override {
    while (!native_->empty()) {
      expected_.emplace_back(transaction, native_->pop());
      ledger.expect(transaction);
    }
  }
  void drive(Random&, bool stall) override {
    ready_ = !stall;
    pins_.ready.set(ready_);
  }
  void observe(Ledger& ledger) override {
    const bool valid = pins_.valid.get() != 0;
    const T token = get<T>();
    if (held_up_ && !valid) {
      throw Mismatch(fmt::format("port {}: valid was taken back before ready came", name_));
    }
    if (held_up_ && hls::pack(token) != held_) {
      throw Mismatch(fmt::format("port {}: the token changed before ready came, to {}", name_,
                                 hls::describe(token)));
    }
    held_up_ = valid && !ready_;
    held_ = hls::pack(token);
    moved_ = valid && ready_;
    if (!moved_) return;
    if (expected_.empty()) {
      throw Mismatch(fmt::format("port {}: RTL gives a token that the model does not: {}", name_,
                                 hls::describe(token)));
    }
    compare("token", token, expected_.front().second, expected_.front().first);
    ledger.seen(expected_.front().first);
    expected_.pop_front();
  }
  std::string waiting() const override {
    if (expected_.empty()) return {};
    return fmt::format("{} owes token {} of transaction {}: {}", name_, compared_,
                       expected_.front().first, hls::describe(expected_.front().second));
  }

 private:
  std::shared_ptr<hls::Fifo<T>> native_;
  std::deque<std::pair<std::uint64_t, T>> expected_;
  hls::Words<T> held_{};
  bool ready_ = false;
};

/// A RAM of another unit, whose contents stand still. The data of an address are on the pins in one
/// clock only, `Latency` clocks after it.
template <class T, unsigned N, unsigned Latency>
class RamReadPort : public PortModel, public Drawn<T> {
 public:
  RamReadPort(std::string name, PortPins pins, hls::RamRead<T, N, Latency>& native)
      : PortModel(std::move(name), pins), rows_(std::make_shared<std::vector<T>>(N)) {
    native.bind(rows_);
  }
  void prepare(Random& random) override {
    for (auto&& row : *rows_) {  // a vector<bool> has no references
      T value = row;
      this->draw_value(value, random);
      row = value;
    }
  }
  void drive(Random& random, bool) override {
    if (due_.size() == Latency && due_.front()) {
      put<T>((*rows_)[*due_.front()]);
    } else {
      put_garbage<T>(random);
    }
  }
  void observe(Ledger&) override {
    moved_ = pins_.enable.get() != 0;
    address_ = pins_.address.get();
    if (moved_ && address_ >= N) {
      throw Mismatch(fmt::format("port {}: RTL reads row {} of {}", name_, address_, N));
    }
  }
  void edge(Ledger&) override {
    due_.push_back(moved_ ? std::optional(address_) : std::nullopt);
    if (due_.size() > Latency) due_.pop_front();
  }

 private:
  std::shared_ptr<std::vector<T>> rows_;
  std::deque<std::optional<std::uint64_t>> due_;
  std::uint64_t address_ = 0;
};

template <class T, unsigned N>
class RamWritePort : public PortModel {
 public:
  RamWritePort(std::string name, PortPins pins, hls::RamWrite<T, N>& native)
      : PortModel(std::move(name), pins) {
    native.record(&log_);
  }
  void collect(std::uint64_t transaction, Ledger& ledger) override {
    for (const auto& [address, row] : log_) {
      expected_.push_back({transaction, address, row});
      ledger.expect(transaction);
    }
    log_.clear();
  }
  void observe(Ledger& ledger) override {
    moved_ = pins_.enable.get() != 0;
    if (!moved_) return;
    const std::uint64_t address = pins_.address.get();
    const T row = get<T>();
    if (expected_.empty()) {
      throw Mismatch(fmt::format("port {}: RTL writes row {}, the model writes none: {}", name_,
                                 address, hls::describe(row)));
    }
    const Write& write = expected_.front();
    if (address != write.address) {
      throw Mismatch(fmt::format("port {}, write {}: RTL writes row {}, the model row {}", name_,
                                 compared_, address, write.address),
                     write.transaction);
    }
    compare("write", row, write.row, write.transaction);
    ledger.seen(write.transaction);
    expected_.pop_front();
  }
  std::string waiting() const override {
    if (expected_.empty()) return {};
    const Write& write = expected_.front();
    return fmt::format("{} owes write {} of transaction {}: row {}: {}", name_, compared_,
                       write.transaction, write.address, hls::describe(write.row));
  }

 private:
  struct Write {
    std::uint64_t transaction, address;
    T row;
  };
  typename hls::RamWrite<T, N>::Log log_;
  std::deque<Write> expected_;
};

template <class T>
class ConfigPort : public PortModel, public Drawn<T> {
 public:
  ConfigPort(std::string name, PortPins pins, hls::Config<T>& native)
      : PortModel(std::move(name), pins), value_(std::make_shared<T>()) {
    native.bind(value_);
  }
  void prepare(Random& random) override {
    this->draw_value(*value_, random);
    put(*value_);
  }

 private:
  std::shared_ptr<T> value_;
};

}  // namespace dynrt::cosim
