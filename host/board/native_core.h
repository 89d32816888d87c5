// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The native core of configuration C behind ModelBoard's interface.
#pragma once

#include "host/board/model_board.h"
#include "units/core_model.h"

namespace dynrt::host {

template <class C>
class NativeCoreOf final : public NativeCore {
 public:
  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override {
    with_bank(bank, [&]<unsigned W>(hls::Rows<uint<W>>& to) {
      constexpr unsigned kParts = (W + 31) / 32;
      for (std::size_t i = 0; i < words.size() / kParts; ++i) {
        std::uint64_t word = 0;
        for (unsigned p = 0; p < kParts; ++p) {
          word |= std::uint64_t{words[i * kParts + p]} << (32 * p);
        }
        to[address + i] = uint<W>::from(word);
      }
    });
  }
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override {
    with_bank(bank, [&]<unsigned W>(const hls::Rows<uint<W>>& from) {
      constexpr unsigned kParts = (W + 31) / 32;
      for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] =
            static_cast<std::uint32_t>(from[address + i / kParts].to_u64() >> (32 * (i % kParts)));
      }
    });
  }
  std::optional<std::uint64_t> render(const FrameConfig& frame,
                                      const hls::ModuleSchedules* schedule,
                                      FrameWatch* watch) override {
    return core_.render(frame, schedule, watch);
  }
  void set_memory_timing(const MemoryTiming& timing) override { core_.set_timing(timing); }
  CoreModel<C>& model() { return core_; }
  std::vector<Counter> counters() override {
    std::vector<Counter> counters;
    for (const auto& [name, value, order_independent] : core_.counters()) {
      counters.push_back({name, value, order_independent});
    }
    return counters;
  }

 private:
  template <class Do>
  void with_bank(unsigned bank, Do&& action) {
    if (bank < kSceneBanks) {
      action(core_.banks().scene[bank]);
    } else {
      action(core_.banks().out.at(bank - kSceneBanks));
    }
  }

  CoreModel<C> core_;
};

}  // namespace dynrt::host
