// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The native core of configuration C behind the interface that ModelBoard needs.
#pragma once

#include "host/board/model_board.h"
#include "units/core_model.h"

namespace dynrt::host {

/// What the host has to know of a configuration; its name is the table's to give.
template <class C>
BoardInfo board_info_of() {
  BoardInfo info;
  info.packets = C::kPackets;
  info.cache_lines = C::kLines;
  info.stack_depth = C::kStackDepth;
  info.lights = C::kLights;
  info.reflections = C::kReflections;
  info.clips_to_cube = kClipsToBox<C>;
  info.triangle_matrix = C::kTriangleMatrix;
  info.primitives = C::kPrimitives;
  info.triangle_test = C::kTriangleTest;
  return info;
}

template <class C>
class NativeCoreOf final : public NativeCore {
 public:
  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override {
    for (std::size_t i = 0; i < words.size(); ++i) {
      core_.bank(bank)[address + i] = Word::from(words[i]);
    }
  }
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override {
    for (std::size_t i = 0; i < words.size(); ++i) {
      words[i] = static_cast<std::uint32_t>(core_.bank(bank)[address + i].to_u64());
    }
  }
  void render(const FrameConfig& frame) override { core_.render(frame); }
  std::vector<Counter> counters() override {
    std::vector<Counter> counters;
    for (const auto& [name, value, order_independent] : core_.counters()) {
      counters.push_back({name, value, order_independent});
    }
    return counters;
  }

 private:
  CoreModel<C> core_;
};

}  // namespace dynrt::host
