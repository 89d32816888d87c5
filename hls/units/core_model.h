// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The core as a program: frames rendered by the native units, from and into the six memory banks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "units/core.h"
#include "units/core_watch.h"
#include "units/port_memory.h"

namespace dynrt {

struct CoreCounter {
  std::string name;
  std::uint64_t value;
  /// The same for every order of the packets; of one of several pipelines, the sum over all is.
  bool order_independent;
};

template <class C>
class CoreModel {
 public:
  CoreModel() {
    const auto make = []<class Bank>(Bank& bank) { bank = Bank(kBankWords); };
    for (auto& bank : banks_.scene) make(bank);
    for (auto& bank : banks_.out) make(bank);
  }
  Banks<C>& banks() { return banks_; }
  /// Of a memory behind the port.
  void set_timing(const MemoryTiming& timing) { timing_ = timing; }
  /// Another memory in its place, made for each frame.
  using MakeMemory = std::function<std::unique_ptr<hls::Device>(Core<C>&, Banks<C>&)>;
  void set_memory(MakeMemory make) { make_memory_ = std::move(make); }

  /// Renders one frame. As on the board, every frame starts with registers reset and caches empty.
  /// With the schedules of its units it does so clock by clock and gives the clocks that the board
  /// would count. What `watch` wants is noted on the way.
  std::optional<std::uint64_t> render(const FrameConfig& config,
                                      const hls::ModuleSchedules* schedule = nullptr,
                                      FrameWatch* watch = nullptr) {
    hls::Join join = schedule ? hls::Join(*schedule) : hls::Join();
    const auto core = std::make_unique<Core<C>>(join, banks_);
    *core->frame = registers_of<C>(config);
    std::unique_ptr<CoreWatch<C>> watching;
    if (watch != nullptr) watching = std::make_unique<CoreWatch<C>>(join, *core, *watch);
    std::unique_ptr<hls::Device> memory;
    if constexpr (kHasPort<C>) {
      memory = make_memory_ ? make_memory_(*core, banks_)
                            : std::make_unique<PortMemory<C>>(core->memory.read, core->memory.beat,
                                                              core->memory.write, banks_, timing_);
      join.attach("memory_read", "memory_beat", *memory, "memory_write");
    }
    std::uint64_t clock = kResetRegister;
    const auto send = [&](std::uint64_t number) {
      core->start->push(uint<10>::from(number));
      if (schedule) join.arrives("start", clock++);
    };
    for (std::uint64_t line = 0; line <= config.line_mask.to_u64(); ++line) send(line);
    clock += kStartPause;
    for (std::uint64_t p = 0; p < config.packets.to_u64(); ++p) send(kFirstPacket + p);
    if (schedule) {
      join.run_clocks();
    } else {
      join.run();
    }
    const std::map<std::string, std::uint64_t> values = join.counters();
    counters_.clear();
    for (const hls::CounterRecord& counter : hls::counters_of(join.record())) {
      const auto value = values.find(counter.name());
      if (value == values.end()) continue;  // stalls, if there is no clock
      counters_.push_back({value->first, value->second, counter.order_independent});
    }
    if (core->done->size() != 1) {
      throw std::logic_error("the core came to rest before the frame was complete");
    }
    if (!schedule) return std::nullopt;
    return join.first_of("done") + 1;
  }

  /// Of the last frame: transactions of every unit, tokens of every channel.
  const std::vector<CoreCounter>& counters() const { return counters_; }

 private:
  Banks<C> banks_;
  MemoryTiming timing_;
  MakeMemory make_memory_;
  std::vector<CoreCounter> counters_;
};

}  // namespace dynrt
