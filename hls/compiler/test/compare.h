// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs a unit twice on the same random tokens: compiled natively, and as the netlist that the front
// end makes of it, interpreted. Every token and every row that either writes must be the same.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cosim/native_model.h"
#include "cosim/netlist_model.h"

namespace hlsc::test {

/// Draws for a port of the native unit and gives the same to the netlist's.
class PortPair {
 public:
  PortPair(hls::cosim::ModelPort& native, hls::cosim::ModelPort& netlist)
      : native_(native), netlist_(netlist), drawn_(hls::cosim::zero_bits(native.type().width)) {
    EXPECT_EQ(native.name(), netlist.name());
    EXPECT_TRUE(native.type() == netlist.type()) << native.name() << " is another port";
  }

  /// Rows and configuration values, once.
  void prepare(hls::cosim::Random& random) {
    if (native_.type().kind == hls::PortKind::kConfig) give(random);
    if (native_.type().kind != hls::PortKind::kRamRead) return;
    const std::uint64_t rows = std::uint64_t{1} << address_width(native_.type().rows);
    for (std::uint64_t row = 0; row < rows; ++row) {
      native_.randomise(drawn_, random);
      native_.give_row(row, drawn_);
      netlist_.give_row(row, drawn_);
    }
  }
  void draw(hls::cosim::Random& random) {
    if (native_.type().kind == hls::PortKind::kIn) give(random);
  }
  /// Compares what a transaction has written; returns how many tokens.
  unsigned compare() {
    const auto token = native_.take();
    const auto lowered = netlist_.take();
    EXPECT_EQ(token.has_value(), lowered.has_value())
        << native_.name() << " is written only on one side";
    if (token && lowered) expect_equal(*lowered, *token);
    const auto write = native_.take_write();
    const auto lowered_write = netlist_.take_write();
    EXPECT_EQ(write.has_value(), lowered_write.has_value())
        << "a row of " << native_.name() << " is written only on one side";
    if (write && lowered_write) {
      EXPECT_EQ(write->address, lowered_write->address) << native_.name();
      expect_equal(lowered_write->row, write->row);
    }
    return token ? 1 : 0;
  }

 private:
  void give(hls::cosim::Random& random) {
    native_.randomise(drawn_, random);
    native_.give(drawn_);
    netlist_.give(drawn_);
  }
  void expect_equal(const hls::cosim::TokenBits& lowered, const hls::cosim::TokenBits& native) {
    if (const auto difference = native_.difference(lowered, native)) {
      ADD_FAILURE() << native_.name() << ", field " << difference->field << ": netlist "
                    << difference->left << ", native " << difference->right;
    }
  }
  hls::cosim::ModelPort& native_;
  hls::cosim::ModelPort& netlist_;
  hls::cosim::TokenBits drawn_;
};

/// Compares `transactions` of the unit and a netlist of it; the seed is printed where it matters.
template <class Unit>
void compare_unit(const Netlist& netlist, unsigned transactions, std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  hls::cosim::Random random(seed);
  hls::cosim::NativeModel<Unit> native;
  NetlistModel lowered(netlist);
  ASSERT_EQ(native.ports().size(), lowered.ports().size());
  std::vector<PortPair> pairs;
  for (const auto& port : native.ports()) {
    for (const auto& other : lowered.ports()) {
      if (other->name() == port->name()) pairs.emplace_back(*port, *other);
    }
  }
  ASSERT_EQ(pairs.size(), native.ports().size());
  for (PortPair& pair : pairs) pair.prepare(random);
  unsigned compared = 0;
  for (unsigned i = 0; i < transactions && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("transaction " + std::to_string(i));
    for (PortPair& pair : pairs) pair.draw(random);
    native.step();
    lowered.step();
    for (PortPair& pair : pairs) compared += pair.compare();
  }
  EXPECT_GE(compared, transactions / 10) << "the test compared too few tokens to prove anything";
}

}  // namespace hlsc::test
