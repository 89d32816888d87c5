// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The board whose core is the native C++ of the units. It has no clock, so a frame takes no cycles
// unless the schedules of the units say how many it would, and no bus; what the host moves is
// metered as if it went over one.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "hls/module_schedule.h"
#include "host/board/board.h"

namespace dynrt::host {

/// What ModelBoard needs of the native core of one configuration.
class NativeCore {
 public:
  virtual ~NativeCore() = default;
  virtual void write(unsigned bank, std::uint32_t address,
                     std::span<const std::uint32_t> words) = 0;
  virtual void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) = 0;
  /// With schedules clock by clock; the clocks that it took, or none.
  virtual std::optional<std::uint64_t> render(const FrameConfig& frame,
                                              const hls::ModuleSchedules* schedule) = 0;
  virtual std::vector<Counter> counters() = 0;
};
using MakeNativeCore = std::unique_ptr<NativeCore> (*)();

class ModelBoard final : public Board {
 public:
  /// `schedules`, if not empty, is the folder of the schedules by which clocks are counted; throws
  /// UserError if they cannot be read.
  ModelBoard(CoreInfo core, std::unique_ptr<NativeCore> native, const std::string& schedules = {});

  void write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) override;
  void read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) override;
  void configure(const FrameConfig& frame) override;
  void start() override;
  /// Renders; there is no clock to run out of, so `timeout` plays no part.
  FrameRun wait(std::uint64_t timeout, const PixelProgress& progress) override;
  std::vector<Counter> counters() override { return native_->counters(); }

 private:
  std::unique_ptr<NativeCore> native_;
  std::string schedules_;
  std::optional<hls::ModuleSchedules> schedule_;
  FrameConfig frame_;
};

}  // namespace dynrt::host
