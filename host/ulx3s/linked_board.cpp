// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/ulx3s/linked_board.h"

#include <algorithm>
#include <array>
#include <utility>

#include "host/board/registers.h"
#include "host/format/port_address.h"

namespace dynrt::host {

namespace reg = registers;

namespace {

bool in_window(std::uint32_t address) { return (address >> reg::kWindowBit & 1) != 0; }
unsigned bank_of(std::uint32_t address) { return address >> reg::kWindowBankLow & 7; }
std::uint32_t word_of(std::uint32_t address) {
  return address >> reg::kWindowWordLow & (kBankWords - 1);
}

/// Words by their addresses as runs of bytes.
std::vector<MemoryBytes> parts_of(const std::map<std::uint32_t, std::uint32_t>& words) {
  std::vector<MemoryBytes> parts;
  for (const auto& [address, word] : words) {
    if (parts.empty() || parts.back().address + parts.back().bytes.size() != address) {
      parts.push_back({address, {}});
    }
    for (unsigned shift = 0; shift < 32; shift += 8) {
      parts.back().bytes.push_back(static_cast<std::uint8_t>(word >> shift));
    }
  }
  return parts;
}

}  // namespace

LinkedBoard::LinkedBoard(std::unique_ptr<BoardLink> link, BackDoor* door, Pause pause)
    : link_(std::move(link)), door_(door), pause_(std::move(pause)) {}

bool LinkedBoard::write(std::uint32_t address, std::span<const std::uint32_t> words) {
  if (in_window(address)) {
    write_window(bank_of(address), word_of(address), words);
    return true;
  }
  const bool starts = address == reg::kRegControl && (words[0] >> reg::kControlStart & 1) != 0;
  if (starts) {
    send_memory();
    clocks_ = 0;
  }
  link_->write_registers(address, words);
  if (address == reg::kRegIrqPending) interrupt_ = false;
  return true;
}

bool LinkedBoard::read(std::uint32_t address, std::span<std::uint32_t> words) {
  if (in_window(address)) {
    read_window(bank_of(address), word_of(address), words);
  } else {
    link_->read_registers(address, words);
  }
  return true;
}

bool LinkedBoard::run_until_interrupt(std::uint64_t limit) {
  static_assert(reg::kRegCyclesLow == reg::kRegIrqPending + 4 &&
                reg::kRegCyclesHigh == reg::kRegCyclesLow + 4);
  const std::uint64_t before = clocks_;
  while (!interrupt_ && clocks_ < before + limit) {
    pause_();
    std::array<std::uint32_t, 3> state{};
    link_->read_registers(reg::kRegIrqPending, state);
    interrupt_ = state[0] != 0;
    clocks_ = std::max(before + 1, state[1] | std::uint64_t{state[2]} << 32);
  }
  return interrupt_;
}

void LinkedBoard::send_memory() {
  kept_ = {};
  const std::vector<MemoryBytes> changes = plan_.changes(parts_of(written_));
  written_.clear();
  upload_ = upload_cost(changes);
  if (door_ == nullptr) {
    link_->write_memory(changes);
  } else {
    for (const MemoryBytes& part : changes) door_->write(part.address, part.bytes);
  }
}

void LinkedBoard::write_window(unsigned bank, std::uint32_t word,
                               std::span<const std::uint32_t> words) {
  for (const std::uint32_t value : words) written_[port_place(bank, word++).byte] = value;
}

void LinkedBoard::read_window(unsigned bank, std::uint32_t word, std::span<std::uint32_t> words) {
  if (words.empty()) return;
  if (!written_.empty()) send_memory();
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
      link_->read_memory(address, kept_.bytes);
    } else {
      door_->read(address, kept_.bytes);
    }
  }
  return kept_.bytes;
}

}  // namespace dynrt::host
