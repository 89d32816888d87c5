// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs a unit twice on the same random tokens: compiled natively, and as the netlist that the front
// end makes of it, interpreted. Every token and every row that either writes must be the same.
// Leaves are small numbers, extremes or uniformly random, so that rare equalities happen.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

#include "hls/ports.h"
#include "netlist/interpret.h"

namespace hlsc::test {

using Random = std::mt19937_64;

inline std::uint64_t random_leaf(Random& random, unsigned width) {
  const std::uint64_t ones = width < 64 ? (std::uint64_t{1} << width) - 1 : ~std::uint64_t{0};
  switch (random() % 8) {
    case 0:
      return 0;
    case 1:
      return ones;
    case 2:
      return ones ^ (random() % 4 & ones);
    case 3:
    case 4:
      return random() % 4 & ones;
    case 5:
      return (random() & ones) >> (random() % width);
    default:
      return random() & ones;
  }
}

/// A token with random leaves; a leaf of an enum may be any number of its width.
template <class T>
T random_token(Random& random) {
  T token{};
  hls::for_each_leaf(token, [&]<class L>(L& leaf, unsigned) {
    constexpr unsigned kWidth = hls::bit_width_of<L>();
    leaf = hls::leaf_from_bits<L>(hls::uint<kWidth>::from(random_leaf(random, kWidth)));
  });
  return token;
}

template <class T>
Bits pack(const T& token) {
  Bits bits(hls::bit_width_of<T>(), 0);
  hls::for_each_leaf(token, [&](const auto& leaf, unsigned offset) {
    const auto raw = hls::leaf_to_bits(leaf);
    for (unsigned i = 0; i < raw.kWidth; ++i) bits.set(offset + i, raw.bit(i));
  });
  return bits;
}

/// "bank[0]" of HLS_PORTS is the netlist's bank_0.
inline std::string netlist_name(std::string name) {
  std::erase(name, ']');
  for (char& c : name) {
    if (c == '[') c = '_';
  }
  return name;
}

template <class Unit>
class Comparison {
 public:
  Comparison(const Netlist& netlist, Random& random)
      : netlist_(netlist), interpreter_(netlist), random_(random) {
    for_each_port([&](auto& port, unsigned index) { bind(port, index); });
  }

  /// One transaction of both; returns how many tokens were compared.
  unsigned step() {
    std::vector<Bits> tokens(netlist_.ports.size());
    for_each_port([&]<class P>(P& port, unsigned index) {
      if constexpr (P::kPort.kind == PortKind::kIn) {
        const auto token = random_token<typename P::Data>(random_);
        port.queue()->push(token);
        tokens[index] = pack(token);
      }
    });
    unit_.step();
    const auto written = interpreter_.step(tokens);
    unsigned compared = 0;
    for_each_port([&](auto& port, unsigned index) { compared += compare(port, index, written); });
    return compared;
  }

  /// Compares what lies in every RAM behind a RamWrite.
  void compare_rows() {
    for_each_port([&]<class P>(P&, unsigned index) {
      if constexpr (P::kPort.kind == PortKind::kRamWrite) {
        using Value = typename P::Data;
        const auto& rows = *std::static_pointer_cast<std::vector<Value>>(rows_[index]);
        for (std::size_t i = 0; i < rows.size(); ++i) {
          EXPECT_TRUE(interpreter_.rows(index)[i] == pack<Value>(rows[i]))
              << netlist_.ports[index].name << " row " << i << " differs";
        }
      }
    });
  }

  template <class Visit>
  void for_each_port(Visit&& visit) {
    std::string names(Unit::hls_field_names());
    const auto visit_present = [&]<class P>(P& port) {
      const std::string name = take_name(names);
      if constexpr (!std::is_same_v<P, hls::Absent>) visit(port, port_index(name));
    };
    std::apply([&](auto&... port) { (visit_present(port), ...); }, unit_.hls_fields());
  }

 private:
  /// Takes the first name off the list.
  static std::string take_name(std::string& names) {
    const auto comma = names.find(',');
    const std::string name = netlist_name(names.substr(0, comma));
    names =
        comma == std::string::npos ? "" : names.substr(names.find_first_not_of(" \n", comma + 1));
    return name;
  }
  unsigned port_index(const std::string& name) const {
    for (unsigned i = 0; i < netlist_.ports.size(); ++i) {
      if (netlist_.ports[i].name == name) return i;
    }
    throw std::runtime_error("no port is called " + name);
  }

  template <class P>
  void bind(P& port, unsigned index) {
    using Value = typename P::Data;
    constexpr PortKind kKind = P::kPort.kind;
    if constexpr (kKind == PortKind::kIn || kKind == PortKind::kOut) {
      auto queue = std::make_shared<hls::Fifo<Value>>();
      port.bind(queue);
      queues_[index] = queue;
    } else if constexpr (kKind == PortKind::kConfig) {
      const auto value = std::make_shared<Value>(random_token<Value>(random_));
      port.bind(value);
      interpreter_.set_config(index, pack(*value));
    } else {
      // As many rows as the address has values.
      auto rows = std::make_shared<std::vector<Value>>(std::size_t{1} << P::Address::kWidth);
      interpreter_.rows(index).assign(rows->size(), Bits(netlist_.ports[index].width, 0));
      for (std::size_t i = 0; i < rows->size(); ++i) {
        const auto row = random_token<Value>(random_);
        (*rows)[i] = row;
        interpreter_.rows(index)[i] = pack(row);
      }
      port.bind(rows);
      rows_[index] = rows;
    }
  }

  template <class P>
  unsigned compare(P&, unsigned index, const std::vector<std::optional<Bits>>& written) {
    using Value = typename P::Data;
    constexpr PortKind kKind = P::kPort.kind;
    const std::string& name = netlist_.ports[index].name;
    if constexpr (kKind == PortKind::kOut) {
      auto& queue = *std::static_pointer_cast<hls::Fifo<Value>>(queues_[index]);
      EXPECT_EQ(written[index].has_value(), !queue.empty()) << name << " is written by one only";
      if (queue.empty() || !written[index]) return 0;
      EXPECT_TRUE(*written[index] == pack(queue.pop())) << name << " differs";
      return 1;
    } else {
      return 0;
    }
  }

  const Netlist& netlist_;
  Interpreter interpreter_;
  Random& random_;
  Unit unit_;
  std::map<unsigned, std::shared_ptr<void>> queues_;
  std::map<unsigned, std::shared_ptr<void>> rows_;
};

/// Compares `transactions` of the unit and a netlist of it; the seed is printed where it matters.
template <class Unit>
void compare_unit(const Netlist& netlist, unsigned transactions, std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Comparison<Unit> comparison(netlist, random);
  unsigned compared = 0;
  for (unsigned i = 0; i < transactions && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("transaction " + std::to_string(i));
    compared += comparison.step();
  }
  comparison.compare_rows();
  EXPECT_GE(compared, transactions / 10) << "too few tokens were written to prove anything";
}

}  // namespace hlsc::test
