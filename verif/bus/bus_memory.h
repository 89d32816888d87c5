// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What a memory on a bus has, whatever the bus: the words of the banks where the core's port has
// them (units/memory_format.h), a temper, and errors where a test wants them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>

#include "host/board/port_sram.h"

namespace dynrt::host::bus {

/// How often in a hundred clocks it is ready for a request, and gives an answer that is there; and
/// the clocks, at most, after which it is there.
struct Temper {
  unsigned ready = 100;
  unsigned answers = 100;
  unsigned most_clocks = 0;
};

/// Of an access that gets an error: as MEMORY_ERROR tells of it.
struct Fault {
  bool write = false;
  unsigned response = 0;
  unsigned byte = 0;
  friend bool operator==(const Fault&, const Fault&) = default;
};

class BusMemory {
 public:
  static constexpr unsigned kBytes = 1u << kMemoryAddressBits;

  BusMemory(const Temper& temper, int seed)
      : temper_(temper), random_(static_cast<unsigned>(seed)) {}

  Sram& sram() { return sram_; }
  const Sram& sram() const { return sram_; }
  /// Where the memory begins on the bus.
  void set_base(std::uint64_t base) { base_ = base; }
  /// It takes nothing and answers nothing for so many clocks.
  void stall(std::uint64_t clocks) { stalled_until_ = now_ + clocks; }
  /// The response to an access of a byte, 0 if it is none of an error.
  void set_faults(std::function<unsigned(bool write, unsigned byte)> faults) {
    faults_ = std::move(faults);
  }
  /// The first error that the bus has taken.
  const std::optional<Fault>& first_fault() const { return first_fault_; }
  void forget_fault() { first_fault_.reset(); }
  std::uint64_t reads() const { return reads_; }
  std::uint64_t writes() const { return writes_; }

 protected:
  bool happens(unsigned percent) { return now_ >= stalled_until_ && random_() % 100 < percent; }
  std::uint64_t some_clocks() { return random_() % (temper_.most_clocks + 1u); }
  std::uint8_t some_byte() { return static_cast<std::uint8_t>(random_()); }

  /// Throws std::logic_error for an address that is not in the memory.
  unsigned byte_of(std::uint64_t address) const {
    if (address < base_ || address - base_ >= kBytes) {
      throw std::logic_error("an access to the bus lies outside of the memory");
    }
    return static_cast<unsigned>(address - base_);
  }
  unsigned response(bool write, unsigned byte) const { return faults_ ? faults_(write, byte) : 0; }
  void seen(const Fault& fault) {
    if (!first_fault_) first_fault_ = fault;
  }
  /// Data of an answer; of one with an error, anything.
  void load(unsigned byte, bool fault, std::span<std::uint8_t> data) {
    for (std::uint8_t& value : data) {
      value = fault ? some_byte() : port_byte(sram_, byte);
      ++byte;
    }
  }
  /// Writes the bytes of the strobe. Throws std::logic_error if it divides a half of a word.
  void store(unsigned byte, std::span<const std::uint8_t> data, std::uint64_t strobe) {
    for (unsigned b = 0; b < data.size(); b += 2) {
      const unsigned both = strobe >> b & 3;
      if (both == 0) continue;
      if (both != 3) throw std::logic_error("a write divides a half of a word");
      write_port_half(sram_, byte + b, static_cast<std::uint16_t>(data[b] | data[b + 1] << 8));
    }
  }

  Temper temper_;
  std::uint64_t now_ = 0, stalled_until_ = 0;
  std::uint64_t reads_ = 0, writes_ = 0;

 private:
  std::mt19937 random_;
  std::uint64_t base_ = 0;
  std::function<unsigned(bool, unsigned)> faults_;
  std::optional<Fault> first_fault_;
  Sram sram_{1};
};

/// Sets a pin, which takes the lowest bits of a value.
template <class Pin>
void set(Pin& pin, std::uint64_t value) {
  pin = static_cast<Pin>(value);
}

/// An answer of the registers.
struct RegisterAnswer {
  bool error = false;
  std::uint32_t data = 0;
};

}  // namespace dynrt::host::bus
