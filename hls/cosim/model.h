// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The model that a unit's Verilog is compared with, seen only through its ports: the native unit
// (native_model.h), an interpreted netlist, or anything else that computes transactions. Tokens,
// rows and values are bits here; only a port knows what they mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

#include "hls/bits.h"
#include "hls/port_kind.h"
#include "hls/random.h"

namespace hls::cosim {

using hls::testing::Random;

/// A token, a row or a value, in words of 32 bits, lowest first; bits beyond its width are zero.
using TokenBits = std::vector<std::uint32_t>;

inline TokenBits zero_bits(unsigned width) { return TokenBits((width + 31) / 32, 0); }

/// Random bits.
inline TokenBits random_bits(unsigned width, Random& random) {
  TokenBits bits = zero_bits(width);
  for (std::uint32_t& word : bits) word = static_cast<std::uint32_t>(random.next());
  if (width % 32 != 0) bits.back() &= (std::uint32_t{1} << width % 32) - 1;
  return bits;
}

struct RowWrite {
  std::uint64_t address;
  TokenBits row;
};

/// One port of a model.
class ModelPort {
 public:
  ModelPort(std::string name, PortInfo type) : name_(std::move(name)), type_(type) {}
  virtual ~ModelPort() = default;
  ModelPort(const ModelPort&) = delete;
  ModelPort& operator=(const ModelPort&) = delete;

  const std::string& name() const { return name_; }
  const PortInfo& type() const { return type_; }
  /// The C++ type of its tokens, rows or value.
  virtual std::type_index token_type() const = 0;

  /// Replaces the value by a random one, such that rare cases happen.
  virtual void randomise(TokenBits& bits, Random& random) const = 0;
  virtual std::string describe(const TokenBits& bits) const = 0;
  /// Where two values differ: left is the Verilog's, right the model's.
  virtual std::optional<Difference> difference(const TokenBits& rtl,
                                               const TokenBits& model) const = 0;

  /// An In's next token, or a Config's value.
  virtual void give(const TokenBits& bits) = 0;
  /// A row that a RamRead reads.
  virtual void give_row(std::uint64_t address, const TokenBits& row) = 0;
  /// The next token that a transaction has written to an Out and that was not taken yet.
  virtual std::optional<TokenBits> take() = 0;
  /// The same for a RamWrite.
  virtual std::optional<RowWrite> take_write() = 0;

 private:
  std::string name_;
  PortInfo type_;
};

/// A unit that makes transactions.
class Model {
 public:
  virtual ~Model() = default;
  /// Makes one transaction with the tokens given before.
  virtual void step() = 0;
  /// In the order of the unit's members.
  const std::vector<std::unique_ptr<ModelPort>>& ports() const { return ports_; }

 protected:
  std::vector<std::unique_ptr<ModelPort>> ports_;
};

}  // namespace hls::cosim
