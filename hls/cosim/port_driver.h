// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The bench's end of every kind of port: it drives the pins of the Verilated unit, gives the same
// to the model's port, and compares their results in order.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cosim/ledger.h"
#include "cosim/model.h"
#include "cosim/pins.h"

namespace hls::cosim {

/// The Verilated unit differs from the model.
struct Mismatch : std::runtime_error {
  Mismatch(const std::string& text, std::optional<std::uint64_t> in = std::nullopt)
      : std::runtime_error(text), transaction(in) {}
  std::optional<std::uint64_t> transaction;
};

/// The operations of the bench that all kinds of ports share.
class PortDriver {
 public:
  PortDriver(ModelPort& model, const PortPins& pins) : model_(model), pins_(pins) {}
  virtual ~PortDriver() = default;
  const std::string& name() const { return model_.name(); }
  PortKind kind() const { return model_.type().kind; }
  const ModelPort& model() const { return model_; }

  // Set by the user.
  std::function<void(TokenBits&, Random&)> shape;            ///< changes random values
  std::function<std::uint64_t(const TokenBits&)> packet_of;  ///< of an In's token
  std::function<void(const TokenBits&)> begun;               ///< called with an In's token

  /// Before the run: contents of RAMs and configuration.
  virtual void prepare(Random&) {}
  /// In ports: draws the next transaction's token, and hands it to both units.
  virtual void draw(Random&) {}
  virtual std::optional<std::uint64_t> packet() const { return std::nullopt; }
  virtual void commit(std::uint64_t /*transaction*/) {}
  virtual std::size_t backlog() const { return 0; }
  virtual std::string describe(std::uint64_t /*transaction*/) const { return {}; }
  /// Ports that write: takes the results of the model's transaction.
  virtual void collect(std::uint64_t /*transaction*/, Ledger&) {}
  /// One clock: set the unit's inputs; look at its outputs; the edge has come.
  virtual void drive(Random&, bool /*stall*/) {}
  virtual void observe(Ledger&) {}
  virtual void edge(Ledger&) {}

  bool moved() const { return moved_; }      ///< a token or row passed in this clock
  bool held_up() const { return held_up_; }  ///< an output that is offered but not taken
  std::uint64_t compared() const { return compared_; }
  /// Describes the token or row that it still waits for; else empty.
  virtual std::string waiting() const { return {}; }

 protected:
  void redraw(TokenBits& bits, Random& random) const {
    model_.randomise(bits, random);
    if (shape) shape(bits, random);
  }
  void compare(const std::string& what, const TokenBits& rtl, const TokenBits& model,
               std::uint64_t transaction);
  TokenBits get() const {
    TokenBits bits = zero_bits(pins_.type.width);
    pins_.data.get_words(bits.data(), static_cast<unsigned>(bits.size()));
    return bits;
  }
  void put(const TokenBits& bits) {
    pins_.data.set_words(bits.data(), static_cast<unsigned>(bits.size()));
  }
  /// The unit must not depend on data that are not valid.
  void put_garbage(Random& random) { put(random_bits(pins_.type.width, random)); }

  ModelPort& model_;
  PortPins pins_;
  bool moved_ = false;
  bool held_up_ = false;
  std::uint64_t compared_ = 0;
};

std::unique_ptr<PortDriver> make_driver(ModelPort& model, const PortPins& pins);

}  // namespace hls::cosim
