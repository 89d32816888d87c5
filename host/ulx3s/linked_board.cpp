// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/ulx3s/linked_board.h"

#include <algorithm>
#include <array>
#include <utility>

#include "host/board/registers.h"
#include "host/board/window.h"
#include "host/format/port_address.h"
#include "host/link/port_image.h"

namespace dynrt::host {

namespace reg = registers;

namespace {

/// Looks at a board that works, each of a millisecond or so, in which its clocks do not change.
constexpr unsigned kMostStill = 1000;

}  // namespace

LinkedBoard::LinkedBoard(std::unique_ptr<BoardLink> link, BackDoor* door, Pause pause)
    : link_(std::move(link)), door_(door), pause_(std::move(pause)) {}

bool LinkedBoard::write(std::uint32_t address, std::span<const std::uint32_t> words) {
  if (window::holds(address)) {
    write_window(window::bank(address), window::word(address), words);
    return true;
  }
  if (address == reg::kRegCounterAddress) {
    counter_ = words[0];  // goes along when the counter is read
    return true;
  }
  const bool starts = address == reg::kRegControl && (words[0] >> reg::kControlStart & 1) != 0;
  if (starts) {
    kept_ = {};  // the frame writes into the memory
    send_memory();
    clocks_ = 0;
  }
  link_->write_registers(address, words);
  bytes_written_ += words.size_bytes();
  if (address == reg::kRegIrqPending) interrupt_ = false;
  return true;
}

bool LinkedBoard::read(std::uint32_t address, std::span<std::uint32_t> words) {
  if (window::holds(address)) {
    read_window(window::bank(address), window::word(address), words);
  } else if (address == reg::kRegCounterData && counter_) {
    words[0] = link_->write_then_read(reg::kRegCounterAddress, *counter_, address);
    bytes_written_ += words.size_bytes();
    bytes_read_ += words.size_bytes();
  } else {
    link_->read_registers(address, words);
    bytes_read_ += words.size_bytes();
  }
  return true;
}

bool LinkedBoard::run_until_interrupt(std::uint64_t limit) {
  static_assert(reg::kRegCyclesLow == reg::kRegIrqPending + 4 &&
                reg::kRegCyclesHigh == reg::kRegCyclesLow + 4);
  const std::uint64_t end = clocks_ + limit;
  for (unsigned still = 0; !interrupt_ && clocks_ < end && still < kMostStill; ++still) {
    pause_();
    std::array<std::uint32_t, 3> state{};
    link_->read_registers(reg::kRegIrqPending, state);
    interrupt_ = state[0] != 0;
    const std::uint64_t clocks = state[1] | std::uint64_t{state[2]} << 32;
    if (clocks > clocks_) still = 0;
    clocks_ = std::max(clocks_, clocks);
  }
  return interrupt_;
}

BusTraffic LinkedBoard::traffic() const {
  const LinkCounts& counts = link_->counts();
  return {.transactions = counts.requests + frames_beside_,
          .bytes_written = bytes_written_,
          .bytes_read = bytes_read_,
          .bus_clocks = (counts.busy + bytes_beside_) * kLineBitsOfByte,
          .clock_hz = kLinkBaud};
}

void LinkedBoard::spare_line(const LineCost& cost) {
  frames_beside_ += cost.frames;
  bytes_beside_ += cost.sent;
}

void LinkedBoard::count_read(std::uint64_t bytes) {
  bytes_read_ += bytes;
  spare_line(read_cost(bytes, link_->board().beat_bytes));
}

LinkProgress LinkedBoard::progress_of(std::string_view what, std::uint64_t total) const {
  if (!progress_) return {};
  return [this, what, total](std::uint64_t done) { progress_(what, done, total); };
}

void LinkedBoard::send_memory() {
  if (written_.empty()) return;
  kept_ = {};
  const std::vector<MemoryBytes> changes = plan_.changes(bytes_of(written_));
  written_.clear();
  std::uint64_t bytes = 0;
  for (const MemoryBytes& part : changes) bytes += part.bytes.size();
  uploaded_ += bytes;
  bytes_written_ += bytes;
  if (door_ == nullptr) {
    link_->write_memory(changes, progress_of("sending the scene", bytes));
  } else {
    spare_line(upload_cost(changes));
    for (const MemoryBytes& part : changes) door_->write(part.address, part.bytes);
  }
}

void LinkedBoard::write_window(unsigned bank, std::uint32_t word,
                               std::span<const std::uint32_t> words) {
  for (const std::uint32_t value : words) {
    const std::uint32_t byte = port_place(bank, word).byte;
    written_[byte] = value;
    if (ends_column(bank, word)) written_[byte + 4] = 0;
    ++word;
  }
}

void LinkedBoard::read_window(unsigned bank, std::uint32_t word, std::span<std::uint32_t> words) {
  if (words.empty()) return;
  send_memory();
  const std::uint32_t first = port_place(bank, word).byte;
  const std::uint32_t stride = port_place(bank, word).stride;
  // The words of both banks of hit records lie side by side.
  const std::uint32_t begin = first / stride * stride;
  const std::span<const std::uint8_t> bytes = memory(begin, words.size() * stride);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t at = first - begin + i * stride;
    words[i] = 0;
    for (unsigned b = 0; b < 4; ++b) words[i] |= std::uint32_t{bytes[at + b]} << (8 * b);
  }
}

std::span<const std::uint8_t> LinkedBoard::memory(std::uint32_t address, std::size_t bytes) {
  if (kept_.address != address || kept_.bytes.size() != bytes) {
    kept_ = {address, std::vector<std::uint8_t>(bytes)};
    if (door_ == nullptr) {
      link_->read_memory(address, kept_.bytes, progress_of("reading its results", bytes));
      bytes_read_ += bytes;
    } else {
      count_read(bytes);
      door_->read(address, kept_.bytes);
    }
  }
  return kept_.bytes;
}

}  // namespace dynrt::host
