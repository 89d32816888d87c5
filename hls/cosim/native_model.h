// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A unit's C++ as a model: its ports are bound to queues and rows of their own.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "cosim/model.h"
#include "hls/join_ports.h"
#include "hls/ports.h"

namespace hls::cosim {

template <class T>
TokenBits to_bits(const T& token) {
  const Words<T> words = pack(token);
  return TokenBits(words.begin(), words.end());
}
template <class T>
T from_bits(const TokenBits& bits) {
  return unpack<T>(bits.data());
}

/// The queue or rows that a native port is bound to, by its kind.
template <class T, PortKind Kind>
struct Binding;
template <class T>
struct Binding<T, PortKind::kIn> {
  std::shared_ptr<Fifo<T>> queue = std::make_shared<Fifo<T>>();
  void bind(auto& port) { port.bind(queue); }
};
template <class T>
struct Binding<T, PortKind::kOut> : Binding<T, PortKind::kIn> {};
template <class T>
struct Binding<T, PortKind::kConfig> {
  std::shared_ptr<T> value = std::make_shared<T>();
  void bind(auto& port) { port.bind(value); }
};
template <class T>
struct Binding<T, PortKind::kRamRead> {
  Rows<T> rows;
  /// As many rows as the address has values.
  template <class Port>
  void bind(Port& port) {
    rows = Rows<T>(std::size_t{1} << Port::Address::kWidth);
    port.bind(rows);
  }
};
template <class T>
struct Binding<T, PortKind::kRamWrite> {
  std::shared_ptr<WriteLog<T>> log = std::make_shared<WriteLog<T>>();
  void bind(auto& port) { port.bind_taker(&log_write<T>, log); }
};

template <class Port>
class NativePort : public ModelPort {
 public:
  using T = typename Port::Data;
  static constexpr PortKind kKind = Port::kPort.kind;

  NativePort(std::string name, Port& port) : ModelPort(std::move(name), Port::kPort) {
    bound_.bind(port);
  }
  std::type_index token_type() const override { return typeid(T); }
  void randomise(TokenBits& bits, Random& random) const override {
    T token = from_bits<T>(bits);
    testing::randomise(token, random);
    bits = cosim::to_bits(token);
  }
  std::string describe(const TokenBits& bits) const override {
    return hls::describe(from_bits<T>(bits));
  }
  std::optional<Difference> difference(const TokenBits& rtl,
                                       const TokenBits& model) const override {
    return first_difference(from_bits<T>(rtl), from_bits<T>(model));
  }

  void give(const TokenBits& bits) override {
    if constexpr (kKind == PortKind::kIn) {
      bound_.queue->push(from_bits<T>(bits));
    } else if constexpr (kKind == PortKind::kConfig) {
      *bound_.value = from_bits<T>(bits);
    } else {
      refuse();
    }
  }
  void give_row(std::uint64_t address, const TokenBits& row) override {
    if constexpr (kKind == PortKind::kRamRead) {
      bound_.rows[address] = from_bits<T>(row);
    } else {
      refuse();
    }
  }
  std::optional<TokenBits> take() override {
    if constexpr (kKind == PortKind::kOut) {
      if (!bound_.queue->empty()) return cosim::to_bits(bound_.queue->pop());
    }
    return std::nullopt;
  }
  std::optional<RowWrite> take_write() override {
    if constexpr (kKind == PortKind::kRamWrite) {
      if (!bound_.log->empty()) {
        RowWrite write{bound_.log->front().first, cosim::to_bits(bound_.log->front().second)};
        bound_.log->erase(bound_.log->begin());
        return write;
      }
    }
    return std::nullopt;
  }

 private:
  [[noreturn]] void refuse() const {
    throw std::logic_error("nothing is given to the port " + name());
  }
  Binding<T, kKind> bound_;
};

template <class Unit>
class NativeModel : public Model {
 public:
  NativeModel() {
    for_each_port(*unit_, [this](const std::string& name, auto& port) { this->add(name, port); });
  }
  void step() override { unit_->step(); }

 private:
  template <class Port>
  void add(const std::string& name, Port& port) {
    ports_.push_back(std::make_unique<NativePort<Port>>(name, port));
  }
  std::unique_ptr<Unit> unit_ = std::make_unique<Unit>();
};

}  // namespace hls::cosim
