// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// An interpreted netlist as a model, for the bench and for comparisons with the native unit.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cosim/model.h"
#include "netlist/interpret.h"
#include "netlist/op.h"

namespace hlsc {

using hls::cosim::TokenBits;

inline Bits to_netlist_bits(const TokenBits& words, unsigned width) {
  Bits bits(width, 0);
  for (unsigned i = 0; i < bits.words(); ++i) {
    std::uint64_t word = words[2 * i];
    if (2 * i + 1 < words.size()) word |= std::uint64_t{words[2 * i + 1]} << 32;
    bits.set_word(i, word);
  }
  return bits;
}
inline TokenBits to_token_bits(const Bits& bits) {
  TokenBits words = hls::cosim::zero_bits(bits.width());
  for (unsigned i = 0; i < words.size(); ++i) {
    words[i] = static_cast<std::uint32_t>(bits.word(i / 2) >> (i % 2 * 32));
  }
  return words;
}

class NetlistPort : public hls::cosim::ModelPort {
 public:
  NetlistPort(const Netlist& netlist, Interpreter& interpreter, unsigned index)
      : ModelPort(netlist.ports[index].name, info(netlist.ports[index])),
        interpreter_(interpreter),
        index_(index) {
    const Port& port = netlist.ports[index];
    // As many rows as the address has values.
    if (is_ram(port.kind)) {
      interpreter.rows(index).resize(std::size_t{1} << address_width(port.rows),
                                     Bits(port.width, 0));
    }
  }
  std::type_index token_type() const override { return typeid(TokenBits); }
  void randomise(TokenBits& bits, hls::cosim::Random& random) const override {
    bits = hls::cosim::random_bits(type().width, random);
    const std::uint64_t kind = random.below(4);  // few ones, few zeros, or as many of both
    const TokenBits other = hls::cosim::random_bits(type().width, random);
    for (std::size_t i = 0; i < bits.size(); ++i) {
      if (kind == 0) bits[i] &= other[i];
      if (kind == 1) bits[i] |= other[i];
    }
  }
  std::string describe(const TokenBits& bits) const override {
    return "0x" + to_hex(to_netlist_bits(bits, type().width));
  }
  std::optional<hls::Difference> difference(const TokenBits& rtl,
                                            const TokenBits& model) const override {
    if (rtl == model) return std::nullopt;
    return hls::Difference{"value", describe(rtl), describe(model)};
  }

  void give(const TokenBits& bits) override {
    given_ = to_netlist_bits(bits, type().width);
    if (type().kind == hls::PortKind::kConfig) interpreter_.set_config(index_, given_);
  }
  void give_row(std::uint64_t address, const TokenBits& row) override {
    interpreter_.rows(index_).at(address) = to_netlist_bits(row, type().width);
  }
  std::optional<TokenBits> take() override { return front(tokens_); }
  std::optional<hls::cosim::RowWrite> take_write() override { return front(writes_); }

  const Bits& given() const { return given_; }
  void wrote(const Bits& token) { tokens_.push_back(to_token_bits(token)); }
  void wrote(std::uint64_t address, const Bits& row) {
    writes_.push_back({address, to_token_bits(row)});
  }

 private:
  static hls::PortInfo info(const Port& port) {
    const bool reads = port.kind == hls::PortKind::kRamRead;
    return {port.kind, port.width, port.rows, reads ? port.latency : 0};
  }
  template <class T>
  static std::optional<T> front(std::deque<T>& queue) {
    if (queue.empty()) return std::nullopt;
    T first = std::move(queue.front());
    queue.pop_front();
    return first;
  }

  Interpreter& interpreter_;
  unsigned index_;
  Bits given_;
  std::deque<TokenBits> tokens_;
  std::deque<hls::cosim::RowWrite> writes_;
};

class NetlistModel : public hls::cosim::Model {
 public:
  /// The netlist must outlive the model.
  explicit NetlistModel(const Netlist& netlist) : interpreter_(netlist) {
    for (unsigned i = 0; i < netlist.ports.size(); ++i) {
      const hls::PortKind kind = netlist.ports[i].kind;
      by_index_.push_back(nullptr);
      if (kind == hls::PortKind::kRam || kind == hls::PortKind::kRegisterFile) continue;
      auto port = std::make_unique<NetlistPort>(netlist, interpreter_, i);
      by_index_.back() = port.get();
      ports_.push_back(std::move(port));
    }
  }
  void step() override {
    std::vector<Bits> tokens(by_index_.size());
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (by_index_[i]) tokens[i] = by_index_[i]->given();
    }
    const auto written = interpreter_.step(tokens);
    for (std::size_t i = 0; i < written.size(); ++i) {
      if (written[i]) by_index_[i]->wrote(*written[i]);
    }
    for (const WrittenRow& write : interpreter_.written_rows()) {
      if (by_index_[write.port]) by_index_[write.port]->wrote(write.address, write.row);
    }
  }

 private:
  Interpreter interpreter_;
  std::vector<NetlistPort*> by_index_;  ///< null: a RAM inside the unit
};

}  // namespace hlsc
