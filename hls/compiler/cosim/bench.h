// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs a Verilated unit beside the interpreter of its netlist: random tokens, valid and ready
// random at every port, RAM ends served from the interpreter's rows; every token written must be
// equal, in order. V is the Verilated class, and its visit_ports_ function is passed in.
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <type_traits>

#include "netlist/interpret.h"
#include "netlist/op.h"

namespace hlsc {

/// A Verilated signal of any width.
struct Pin {
  std::function<Bits()> get;
  std::function<void(const Bits&)> set;
};

template <class S>
Pin make_pin(S& signal, unsigned width) {
  Pin pin;
  if constexpr (std::is_integral_v<S>) {
    pin.get = [&signal, width] { return Bits(width, signal); };
    pin.set = [&signal](const Bits& b) { signal = static_cast<S>(b.low64()); };
  } else {
    pin.get = [&signal, width] {
      Bits b(width, 0);
      for (unsigned i = 0; i < b.words(); ++i) {
        std::uint64_t word = signal[2 * i];
        if (2 * i + 1 < (width + 31) / 32) word |= std::uint64_t{signal[2 * i + 1]} << 32;
        b.set_word(i, word);
      }
      return b;
    };
    pin.set = [&signal, width](const Bits& b) {
      for (unsigned i = 0; i < (width + 31) / 32; ++i) {
        signal[i] = static_cast<std::uint32_t>(b.word(i / 2) >> (i % 2 * 32));
      }
    };
  }
  return pin;
}

class Bench {
 public:
  struct Stalls {
    unsigned in = 4;   ///< an In has no token in one of so many clocks
    unsigned out = 4;  ///< the same for an Out's ready; 1: always stalled
  };

  Bench(const Netlist& netlist, std::uint32_t seed)
      : netlist_(netlist), interpreter_(netlist), random_(seed) {}

  /// Called by visit_ports_<module>().
  struct Visitor {
    Bench& b;
    template <class C, class R>
    void clock(C& clk, R& reset) {
      b.clk_ = make_pin(clk, 1);
      b.reset_ = make_pin(reset, 1);
    }
    template <class A, class B, class D>
    void in(const char* name, unsigned width, A& valid, B& ready, D& data) {
      b.channels_.push_back({b.port(name),
                             true,
                             make_pin(valid, 1),
                             make_pin(ready, 1),
                             make_pin(data, width),
                             {},
                             false});
    }
    template <class A, class B, class D>
    void out(const char* name, unsigned width, A& valid, B& ready, D& data) {
      b.channels_.push_back({b.port(name),
                             false,
                             make_pin(valid, 1),
                             make_pin(ready, 1),
                             make_pin(data, width),
                             {},
                             false});
    }
    template <class A, class B, class D>
    void ram_read(const char* name, unsigned width, unsigned rows, unsigned latency, A& en, B& addr,
                  D& data) {
      b.rams_.push_back({b.port(name),
                         true,
                         latency,
                         make_pin(en, 1),
                         make_pin(addr, address_width(rows)),
                         make_pin(data, width),
                         {}});
    }
    template <class A, class B, class D>
    void ram_write(const char* name, unsigned width, unsigned rows, A& en, B& addr, D& data) {
      b.rams_.push_back({b.port(name),
                         false,
                         0,
                         make_pin(en, 1),
                         make_pin(addr, address_width(rows)),
                         make_pin(data, width),
                         {}});
    }
    template <class D>
    void config(const char* name, unsigned width, D& value) {
      b.configs_.push_back({b.port(name), make_pin(value, width)});
    }
  };
  Visitor visitor() { return {*this}; }

  /// Makes the token number i of an In; random if not set.
  std::function<Bits(unsigned port, unsigned i)> token;

  Bits random_bits(unsigned width) {
    Bits b(width, 0);
    const unsigned kind = random_() % 4;
    for (unsigned i = 0; i < b.words(); ++i) {
      const std::uint64_t word = std::uint64_t{random_()} << 32 | random_();
      b.set_word(i, kind == 0   ? word & (std::uint64_t{random_()} << 32 | random_())
                    : kind == 1 ? word | (std::uint64_t{random_()} << 32 | random_())
                                : word);
    }
    return b;
  }

  /// Runs so many transactions; `eval` evaluates the Verilated model. Returns the clocks taken.
  unsigned run(unsigned transactions, const std::function<void()>& eval, Stalls stalls) {
    for (auto& [port, value] : configs_) {
      const Bits bits = random_bits(netlist_.ports[port].width);
      value.set(bits);
      interpreter_.set_config(port, bits);
    }
    std::map<unsigned, std::vector<Bits>> written;
    for (Ram& ram : rams_) {
      for (Bits& row : interpreter_.rows(ram.port)) {
        if (ram.is_read) row = random_bits(row.width());
      }
      if (!ram.is_read) written[ram.port] = interpreter_.rows(ram.port);
    }
    std::vector<std::deque<Bits>> expected(netlist_.ports.size());
    std::vector<unsigned> taken(netlist_.ports.size(), 0);
    for (unsigned t = 0; t < transactions; ++t) {
      std::vector<Bits> tokens(netlist_.ports.size());
      for (Channel& c : channels_) {
        if (!c.is_in) continue;
        const unsigned width = netlist_.ports[c.port].width;
        tokens[c.port] = token ? token(c.port, t) : random_bits(width);
        c.tokens.push_back(tokens[c.port]);
      }
      const auto out = interpreter_.step(tokens);
      for (unsigned p = 0; p < out.size(); ++p) {
        if (out[p]) expected[p].push_back(*out[p]);
      }
    }

    const auto tick = [&] {
      clk_.set(Bits(1, 0));
      eval();
      clk_.set(Bits(1, 1));
      eval();
    };
    const auto flag = [](bool b) { return Bits(1, b ? 1 : 0); };
    reset_.set(flag(false));
    for (Channel& c : channels_) (c.is_in ? c.valid : c.ready).set(flag(false));
    for (int i = 0; i < 4; ++i) tick();
    reset_.set(flag(true));

    unsigned idle = 0;
    unsigned clocks = 0;
    for (; idle < 400; ++clocks, ++idle) {
      for (Channel& c : channels_) {
        if (c.is_in) {
          // What was offered stays until it is taken.
          c.offered = !c.tokens.empty() && (c.offered || random_() % stalls.in != 0);
          c.valid.set(flag(c.offered));
          c.data.set(c.offered ? c.tokens.front() : random_bits(netlist_.ports[c.port].width));
        } else {
          c.ready.set(flag(random_() % stalls.out != 0));
        }
      }
      for (Ram& ram : rams_) {
        if (!ram.is_read) continue;
        ram.data.set(ram.pipe.size() >= ram.latency ? ram.pipe.front()
                                                    : random_bits(netlist_.ports[ram.port].width));
      }
      clk_.set(flag(false));
      eval();
      for (Channel& c : channels_) {
        if (!c.valid.get().bit(0) || !c.ready.get().bit(0)) continue;
        if (c.is_in) {
          c.tokens.pop_front();
          c.offered = false;
          idle = 0;
          continue;
        }
        const std::string& name = netlist_.ports[c.port].name;
        if (expected[c.port].empty()) {
          ADD_FAILURE() << name << ": a token more than expected";
          return clocks;
        }
        idle = 0;
        const Bits got = c.data.get();
        if (got != expected[c.port].front()) {
          ADD_FAILURE() << name << ": token " << taken[c.port] << " is " << to_hex(got)
                        << " instead of " << to_hex(expected[c.port].front());
          return clocks;
        }
        expected[c.port].pop_front();
        ++taken[c.port];
      }
      for (Ram& ram : rams_) {
        const std::uint64_t address = ram.address.get().low64();
        if (ram.is_read) {
          ram.pipe.push_back(ram.enable.get().bit(0) ? interpreter_.rows(ram.port).at(address)
                                                     : random_bits(netlist_.ports[ram.port].width));
          if (ram.pipe.size() > ram.latency) ram.pipe.pop_front();
        } else if (ram.enable.get().bit(0)) {
          written[ram.port].at(address) = ram.data.get();
        }
      }
      clk_.set(flag(true));
      eval();
    }
    for (const Channel& c : channels_) {
      const std::string& name = netlist_.ports[c.port].name;
      EXPECT_EQ(c.tokens.size(), 0u) << name << ": tokens left";
      EXPECT_EQ(expected[c.port].size(), 0u) << name << ": tokens missing";
      compared += c.is_in ? 0 : taken[c.port];
    }
    for (const auto& [port, rows] : written) {
      EXPECT_TRUE(rows == interpreter_.rows(port)) << netlist_.ports[port].name << ": rows differ";
    }
    return clocks - idle;
  }

  unsigned compared = 0;  ///< tokens

 private:
  struct Channel {
    unsigned port;
    bool is_in;
    Pin valid, ready, data;
    std::deque<Bits> tokens;
    bool offered;
  };
  struct Ram {
    unsigned port;
    bool is_read;
    unsigned latency;
    Pin enable, address, data;
    std::deque<Bits> pipe;
  };

  unsigned port(const std::string& name) const {
    for (unsigned i = 0; i < netlist_.ports.size(); ++i) {
      if (netlist_.ports[i].name == name) return i;
    }
    throw std::out_of_range("no port " + name);
  }

  const Netlist& netlist_;
  Interpreter interpreter_;
  std::mt19937 random_;
  Pin clk_, reset_;
  std::vector<Channel> channels_;
  std::vector<Ram> rams_;
  std::vector<std::pair<unsigned, Pin>> configs_;
};

}  // namespace hlsc
