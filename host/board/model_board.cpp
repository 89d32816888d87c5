// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/board/model_board.h"

#include <chrono>
#include <stdexcept>

#include "host/board/check_range.h"
#include "host/board/check_start.h"
#include "host/board/read_schedule.h"
#include "host/error.h"

namespace dynrt::host {

ModelBoard::ModelBoard(CoreInfo core, std::unique_ptr<NativeCore> native,
                       const std::string& schedules)
    : Board("model", std::move(core)), native_(std::move(native)), schedules_(schedules) {
  if (!schedules.empty()) schedule_ = read_schedule(schedules);
}

void ModelBoard::write(unsigned bank, std::uint32_t address, std::span<const std::uint32_t> words) {
  check_range(*this, bank, address, words.size());
  meter_.write(words.size());
  native_->write(bank, address, words);
}

void ModelBoard::read(unsigned bank, std::uint32_t address, std::span<std::uint32_t> words) {
  check_range(*this, bank, address, words.size());
  meter_.read(words.size());
  native_->read(bank, address, words);
}

void ModelBoard::configure(const FrameConfig& frame) {
  meter_.write(core_.frame_words(frame).size());
  frame_ = frame;
}

void ModelBoard::start() {
  meter_.write(1);
  if (!can_render(core_, frame_)) refuse_start(*this, frame_);
}

FrameRun ModelBoard::wait(std::uint64_t /*timeout*/, const PixelProgress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  std::optional<std::uint64_t> cycles;
  try {
    cycles = native_->render(frame_, schedule_ ? &*schedule_ : nullptr, watch_);
  } catch (const std::invalid_argument& error) {
    refuse("{}: {} of configuration {}; name the folder of that configuration's Verilog",
           schedules_, error.what(), core_.name);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (progress) progress(frame_.width.to_u64() * frame_.height.to_u64());
  return {.cycles = cycles, .scheduled = cycles.has_value(), .seconds = seconds.count()};
}

}  // namespace dynrt::host
