// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The pins of a Verilated unit, found through the binding header that hlsc writes with the Verilog:
//   template <class V, class F> void visit_ports_<module>(V& v, F&& f);
// which calls, in member order,
//   f.clock(clk_i, rst_ni)
//   f.in(name, width, valid_i, ready_o, data_i)      f.out(name, width, valid_o, ready_i, data_o)
//   f.ram_read(name, width, rows, latency, en_o, addr_o, data_i)
//   f.ram_write(name, width, rows, en_o, addr_o, data_o)      f.config(name, width, value_i)
// Elements of an array of ports are name_0, name_1, ...
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "hls/port_kind.h"

namespace hls::cosim {

/// A pin of any width, as 32-bit words, lowest first. Verilator holds a pin of up to 64 bits in an
/// integer and a wider one in a VlWide.
class Pin {
 public:
  Pin() = default;
  template <class Storage>
  explicit Pin(Storage& storage) : bytes_(sizeof(Storage)) {
    if constexpr (requires { storage.m_storage; }) {
      place_ = storage.m_storage;
    } else {
      place_ = &storage;
    }
  }

  void set(std::uint64_t value) const {
    switch (bytes_) {
      case 1:
        *static_cast<std::uint8_t*>(place_) = static_cast<std::uint8_t>(value);
        break;
      case 2:
        *static_cast<std::uint16_t*>(place_) = static_cast<std::uint16_t>(value);
        break;
      case 4:
        *static_cast<std::uint32_t*>(place_) = static_cast<std::uint32_t>(value);
        break;
      default:
        *static_cast<std::uint64_t*>(place_) = value;
        break;
    }
  }
  std::uint64_t get() const {
    switch (bytes_) {
      case 1:
        return *static_cast<std::uint8_t*>(place_);
      case 2:
        return *static_cast<std::uint16_t*>(place_);
      case 4:
        return *static_cast<std::uint32_t*>(place_);
      default:
        return *static_cast<std::uint64_t*>(place_);
    }
  }
  /// `count` words; a pin of up to 64 bits has one or two.
  void set_words(const std::uint32_t* words, unsigned count) const {
    if (count <= 2) {
      set(words[0] | (count == 2 ? std::uint64_t{words[1]} << 32 : 0));
      return;
    }
    for (unsigned i = 0; i < count; ++i) static_cast<std::uint32_t*>(place_)[i] = words[i];
  }
  void get_words(std::uint32_t* words, unsigned count) const {
    if (count <= 2) {
      const std::uint64_t value = get();
      words[0] = static_cast<std::uint32_t>(value);
      if (count == 2) words[1] = static_cast<std::uint32_t>(value >> 32);
      return;
    }
    for (unsigned i = 0; i < count; ++i) words[i] = static_cast<std::uint32_t*>(place_)[i];
  }

 private:
  void* place_ = nullptr;
  unsigned bytes_ = 0;
};

/// One port of the Verilated unit; which pins it has depends on its kind.
struct PortPins {
  PortInfo type = {};
  Pin valid = {}, ready = {}, enable = {}, address = {}, data = {};
};

/// The pins that a binding header's visit fills in.
struct UnitPins {
  Pin clk, rst_n;
  std::map<std::string, PortPins> ports;

  template <class A, class B>
  void clock(A& clk_i, B& rst_ni) {
    clk = Pin(clk_i);
    rst_n = Pin(rst_ni);
  }
  template <class A, class B, class C>
  void in(const char* name, unsigned width, A& valid_i, B& ready_o, C& data_i) {
    ports[name] = {.type = {PortKind::kIn, width},
                   .valid = Pin(valid_i),
                   .ready = Pin(ready_o),
                   .data = Pin(data_i)};
  }
  template <class A, class B, class C>
  void out(const char* name, unsigned width, A& valid_o, B& ready_i, C& data_o) {
    ports[name] = {.type = {PortKind::kOut, width},
                   .valid = Pin(valid_o),
                   .ready = Pin(ready_i),
                   .data = Pin(data_o)};
  }
  template <class A, class B, class C>
  void ram_read(const char* name, unsigned width, unsigned rows, unsigned latency, A& en_o,
                B& addr_o, C& data_i) {
    ports[name] = {.type = {PortKind::kRamRead, width, rows, latency},
                   .enable = Pin(en_o),
                   .address = Pin(addr_o),
                   .data = Pin(data_i)};
  }
  template <class A, class B, class C>
  void ram_write(const char* name, unsigned width, unsigned rows, A& en_o, B& addr_o, C& data_o) {
    ports[name] = {.type = {PortKind::kRamWrite, width, rows},
                   .enable = Pin(en_o),
                   .address = Pin(addr_o),
                   .data = Pin(data_o)};
  }
  template <class A>
  void config(const char* name, unsigned width, A& value_i) {
    ports[name] = {.type = {PortKind::kConfig, width}, .data = Pin(value_i)};
  }
};

}  // namespace hls::cosim
