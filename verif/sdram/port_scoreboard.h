// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Checks the answers of a memory port: an array holds the data written, and each beat is compared
// with the data that its read must return.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "units/sdram_port.h"

namespace dynrt::verif {

template <unsigned PortBytes>
class PortScoreboard {
 public:
  using Types = SdramPortTypes<PortBytes>;
  using Read = typename Types::Read;
  using Write = typename Types::Write;
  using Beat = typename Types::Beat;

  explicit PortScoreboard(std::vector<std::uint16_t> halves) : halves_(std::move(halves)) {}

  void set_half(std::uint32_t half, std::uint16_t value) { halves_[half] = value; }
  /// A read is taken: it must return the present contents of the memory.
  void expect(const Read& read) {
    for (unsigned beat = 0; beat <= read.last; ++beat) {
      Beat b{.id = read.id, .data = {}, .last = beat == read.last};
      const std::uint32_t from = (read.address + beat * PortBytes) / 2;
      for (unsigned i = 0; i < Types::kHalves; ++i) b.data[i] = halves_[from + i];
      expected_[read.id].push_back(b);
    }
  }
  /// A write is taken.
  void store(const Write& write) {
    for (unsigned i = 0; i < Types::kHalves; ++i) {
      if ((write.mask >> i & 1) == 0) continue;
      halves_[write.address / 2 + i] = write.data[i];
      ++halves_written_;
    }
  }
  /// A beat is taken in this clock.
  void compare(const Beat& beat, std::uint64_t clock) {
    ++beats_;
    const auto found = expected_.find(beat.id);
    if (found == expected_.end()) {
      return mistake(fmt::format("clock {}: a beat came that nobody asked for", clock));
    }
    if (inside_ && *inside_ != beat.id) {
      mistake(
          fmt::format("clock {}: beats of id {} came among those of {}", clock, beat.id, *inside_));
    }
    inside_ = beat.last ? std::nullopt : std::optional(beat.id);
    const Beat expected = found->second.front();
    found->second.pop_front();
    if (found->second.empty()) expected_.erase(found);
    if (beat == expected) return;
    mistake(
        fmt::format("clock {}: a beat of id {} has first half {:04x}, last {}; expected {:04x}, {}",
                    clock, beat.id, beat.data[0], beat.last, expected.data[0], expected.last));
  }
  /// All that was asked for has come.
  bool is_idle() const { return expected_.empty(); }

  std::uint64_t beats() const { return beats_; }
  std::uint64_t bytes_written() const { return 2 * halves_written_; }
  const std::vector<std::string>& mistakes() const { return mistakes_; }

 private:
  static constexpr std::size_t kMostMistakes = 20;  ///< that are kept

  void mistake(const std::string& text) {
    if (mistakes_.size() < kMostMistakes) mistakes_.push_back(text);
  }

  std::vector<std::uint16_t> halves_;
  std::unordered_map<std::uint32_t, std::deque<Beat>> expected_;  ///< by id
  std::optional<std::uint32_t> inside_;                           ///< the read whose beats come
  std::uint64_t beats_ = 0;
  std::uint64_t halves_written_ = 0;
  std::vector<std::string> mistakes_;
};

}  // namespace dynrt::verif
