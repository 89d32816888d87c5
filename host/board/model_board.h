// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board whose core is the native C++ of the units. It has no clock, so a frame has a number of
// cycles only if the schedules of the units give it. It has no bus; transfers are counted as if
// they went over one.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "hls/module_schedule.h"
#include "host/board/board.h"

namespace dynrt::host {

/// The interface of the native core of one configuration.
class NativeCore {
 public:
  virtual ~NativeCore() = default;
  virtual void write(unsigned bank, std::uint32_t address,
                     std::span<const std::uint32_t> words) = 0;
  virtual void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) = 0;
  /// Runs clock by clock if it gets schedules, and returns the clocks; none without schedules.
  /// Records into `watch`, if not null, the data that it asks for.
  virtual std::optional<std::uint64_t> render(const FrameConfig& frame,
                                              const hls::ModuleSchedules* schedule,
                                              FrameWatch* watch) = 0;
  virtual void set_memory_timing(const MemoryTiming& /*timing*/) {}
  virtual std::vector<Counter> counters() = 0;
};
using MakeNativeCore = std::unique_ptr<NativeCore> (*)();

class ModelBoard final : public Board {
 public:
  /// `schedules`, if not empty, is the folder of the schedules for counting clocks; throws
  /// UserError if they cannot be read.
  ModelBoard(CoreInfo core, std::unique_ptr<NativeCore> native, const std::string& schedules = {});

  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override;
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override;
  void set_memory_timing(const MemoryTiming& timing) override {
    native_->set_memory_timing(timing);
  }
  void configure(const FrameConfig& frame) override;
  void start() override;
  /// Renders. `timeout` has no effect, as the model has no clock.
  FrameRun wait(std::uint64_t timeout, const PixelProgress& progress) override;
  std::vector<Counter> counters() override { return native_->counters(); }
  void observe(FrameWatch* watch) override { watch_ = watch; }

 private:
  std::unique_ptr<NativeCore> native_;
  std::string schedules_;
  std::optional<hls::ModuleSchedules> schedule_;
  FrameConfig frame_;
  FrameWatch* watch_ = nullptr;
};

}  // namespace dynrt::host
