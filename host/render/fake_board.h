// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A board for the renderer's tests: plain memory, and a frame made by the test.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "host/board/board.h"

namespace dynrt::host {

inline CoreInfo small_core() {
  CoreInfo core;
  core.name = "small";
  core.packets = 8;
  core.lines = 16;
  core.stack_depth = 31;
  return core;
}

class FakeBoard final : public Board {
 public:
  using Memory = std::map<unsigned, std::vector<std::uint32_t>>;
  std::function<void(const FrameConfig&, Memory&)> on_start = [](const FrameConfig&, Memory&) {};
  std::vector<Counter> counter_values;
  Memory memory;
  FrameConfig frame;
  std::uint64_t timeout = 0;

  explicit FakeBoard(CoreInfo core = small_core()) : Board("rtl", std::move(core)) {
    for (unsigned bank = 0; bank < 6; ++bank) memory[bank].resize(1u << 20);
  }
  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override {
    meter_.write(words.size());
    std::ranges::copy(words, memory.at(bank).begin() + address);
  }
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override {
    meter_.read(words.size());
    std::copy_n(memory.at(bank).begin() + address, words.size(), words.begin());
  }
  void configure(const FrameConfig& config) override { frame = config; }
  void start() override { on_start(frame, memory); }
  FrameRun wait(std::uint64_t limit, const PixelProgress&) override {
    timeout = limit;
    return {.cycles = 1000, .seconds = 0.5};
  }
  std::vector<Counter> counters() override { return counter_values; }
};

}  // namespace dynrt::host
