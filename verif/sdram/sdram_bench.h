// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A memory port with an SDRAM behind it, the native model or the Verilog, run with any traffic:
// each beat is compared with an array that holds what was written, and the chip's model checks the
// pins. Traffic is a function that is asked for the next read, or write, when the one before was
// taken.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sdram/port_scoreboard.h"
#include "sdram/sdram_chip.h"
#include "units/sdram_port.h"

namespace dynrt::verif {

template <unsigned PortBytes>
struct SdramTraffic {
  using Types = SdramPortTypes<PortBytes>;
  std::function<std::optional<typename Types::Read>()> read = [] { return std::nullopt; };
  std::function<std::optional<typename Types::Write>()> write = [] { return std::nullopt; };
  std::function<bool()> beat_ready = [] { return true; };
};

/// The place of a half in the chip, as units/sdram_tokens.h has it.
inline std::uint16_t& half_of(SdramChip& chip, std::uint32_t half) {
  return chip.word(half >> 9 & 3, half >> 11, half & 511);
}

inline std::vector<std::uint16_t> contents_of(SdramChip& chip) {
  std::vector<std::uint16_t> halves(1u << (kSdramAddressBits - 1));
  for (std::uint32_t i = 0; i < halves.size(); ++i) halves[i] = half_of(chip, i);
  return halves;
}

template <unsigned PortBytes>
class SdramBench {
 public:
  using Types = SdramPortTypes<PortBytes>;
  using Outputs = typename Types::Outputs;
  using Inputs = typename Types::Inputs;

  explicit SdramBench(SdramChip chip) : chip_(std::move(chip)), expected_(contents_of(chip_)) {}

  /// A clock of `port`, whose outputs() and clock() are those of SdramPort.
  template <class Port>
  void clock(Port& port, const SdramTraffic<PortBytes>& traffic) {
    if (!inputs_.read) inputs_.read = traffic.read();
    if (!inputs_.write) inputs_.write = traffic.write();
    inputs_.beat_ready = traffic.beat_ready();
    inputs_.dq = chip_.dq().value_or(0xdead);
    const Outputs out = port.outputs(inputs_);
    port.clock(inputs_);
    chip_.clock(at_chip(out.pins));
    if (inputs_.read && out.read_ready) {
      expected_.expect(*inputs_.read);
      inputs_.read.reset();
    }
    if (inputs_.write && out.write_ready) {
      expected_.store(*inputs_.write);
      inputs_.write.reset();
    }
    last_beat_.reset();
    if (out.beat && inputs_.beat_ready) {
      last_beat_ = out.beat;
      expected_.compare(*out.beat, clocks_);
    }
    ++clocks_;
  }
  /// What was read in the last clock.
  const std::optional<typename Types::Beat>& last_beat() const { return last_beat_; }
  /// Changes the contents by the back door.
  void set_half(std::uint32_t half, std::uint16_t value) {
    half_of(chip_, half) = value;
    expected_.set_half(half, value);
  }
  bool is_idle() const { return expected_.is_idle() && !inputs_.read && !inputs_.write; }

  SdramChip& chip() { return chip_; }
  std::uint64_t clocks() const { return clocks_; }
  std::uint64_t beats() const { return expected_.beats(); }
  std::uint64_t bytes_written() const { return expected_.bytes_written(); }
  const std::vector<std::string>& mistakes() const { return expected_.mistakes(); }
  /// All that went wrong, and empty if nothing did.
  std::string report() const {
    std::string text;
    for (const std::string& mistake : mistakes()) text += mistake + "\n";
    for (const SdramFault& fault : chip_.faults()) text += fault.text + "\n";
    return text;
  }

 private:
  static SdramChipPins at_chip(const typename Types::Pins& pins) {
    const auto command = static_cast<unsigned>(pins.command);
    SdramChipPins chip{.ras_n = (command & 1) != 0,
                       .cas_n = (command & 2) != 0,
                       .we_n = (command & 4) != 0,
                       .bank = pins.bank,
                       .address = pins.address,
                       .dqm = pins.dqm};
    if (pins.drives) chip.dq = pins.dq;
    return chip;
  }

  SdramChip chip_;
  PortScoreboard<PortBytes> expected_;
  Inputs inputs_;
  std::optional<typename Types::Beat> last_beat_;
  std::uint64_t clocks_ = 0;
};

}  // namespace dynrt::verif
