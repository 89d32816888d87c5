// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A memory port with an SDRAM behind it, the native twin or the Verilog, run with any traffic: each
// beat is compared with an array that holds what was written, and the chip's model checks the pins.
// Traffic is a function that is asked for the next read, or write, when the one before was taken.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

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

template <unsigned PortBytes>
class SdramBench {
 public:
  using Types = SdramPortTypes<PortBytes>;
  using Outputs = typename Types::Outputs;
  using Inputs = typename Types::Inputs;
  static constexpr std::uint32_t kHalves = 1u << (kSdramAddressBits - 1);

  explicit SdramBench(SdramChip chip) : chip_(std::move(chip)), expected_words_(kHalves) {
    for (std::uint32_t i = 0; i < kHalves; ++i) expected_words_[i] = half_of(chip_, i);
  }

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
      expect(*inputs_.read);
      inputs_.read.reset();
    }
    if (inputs_.write && out.write_ready) {
      store(*inputs_.write);
      inputs_.write.reset();
    }
    last_beat_.reset();
    if (out.beat && inputs_.beat_ready) {
      last_beat_ = out.beat;
      compare(*out.beat);
    }
    ++clocks_;
  }
  /// What was read in the last clock.
  const std::optional<typename Types::Beat>& last_beat() const { return last_beat_; }
  /// Changes the contents by the back door.
  void set_half(std::uint32_t half, std::uint16_t value) {
    half_of(chip_, half) = value;
    expected_words_[half] = value;
  }
  bool is_idle() const { return expected_.empty() && !inputs_.read && !inputs_.write; }

  SdramChip& chip() { return chip_; }
  std::uint64_t clocks() const { return clocks_; }
  std::uint64_t beats() const { return beats_; }
  std::uint64_t bytes_written() const { return 2 * halves_written_; }
  const std::vector<std::string>& mistakes() const { return mistakes_; }
  /// All that went wrong, and empty if nothing did.
  std::string report() const {
    std::string text;
    for (const std::string& mistake : mistakes_) text += mistake + "\n";
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
  /// What a read brings is decided where it is taken: requests for the same bytes are done in their
  /// order.
  void expect(const typename Types::Read& read) {
    for (unsigned beat = 0; beat <= read.last; ++beat) {
      typename Types::Beat b{.id = read.id, .data = {}, .last = beat == read.last};
      const std::uint32_t from = (read.address + beat * PortBytes) / 2;
      for (unsigned i = 0; i < Types::kHalves; ++i) b.data[i] = expected_words_[from + i];
      expected_[read.id].push_back(b);
    }
  }
  void store(const typename Types::Write& write) {
    for (unsigned i = 0; i < Types::kHalves; ++i) {
      if ((write.mask >> i & 1) == 0) continue;
      expected_words_[write.address / 2 + i] = write.data[i];
      ++halves_written_;
    }
  }
  void compare(const typename Types::Beat& beat) {
    ++beats_;
    const auto found = expected_.find(beat.id);
    if (found == expected_.end()) {
      return mistake(fmt::format("clock {}: a beat came that nobody asked for", clocks_));
    }
    if (inside_ && *inside_ != beat.id) {
      mistake(fmt::format("clock {}: beats of id {} came among those of {}", clocks_, beat.id,
                          *inside_));
    }
    inside_ = beat.last ? std::nullopt : std::optional(beat.id);
    const auto expected = found->second.front();
    found->second.pop_front();
    if (found->second.empty()) expected_.erase(found);
    if (beat == expected) return;
    mistake(
        fmt::format("clock {}: a beat of id {} has first half {:04x}, last {}; expected {:04x}, {}",
                    clocks_, beat.id, beat.data[0], beat.last, expected.data[0], expected.last));
  }
  void mistake(const std::string& text) {
    if (mistakes_.size() < 20) mistakes_.push_back(text);
  }

  SdramChip chip_;
  std::vector<std::uint16_t> expected_words_;
  Inputs inputs_;
  std::optional<typename Types::Beat> last_beat_;
  std::unordered_map<std::uint32_t, std::deque<typename Types::Beat>> expected_;  ///< by id
  std::optional<std::uint32_t> inside_;  ///< the read whose beats come
  std::uint64_t clocks_ = 0;
  std::uint64_t beats_ = 0;
  std::uint64_t halves_written_ = 0;
  std::vector<std::string> mistakes_;
};

}  // namespace dynrt::verif
