// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The memory at the pins of a board whose core has one port for all (units/memory_port.h). It holds
// the words of the banks where the port has them (units/memory_format.h), and answers at the clocks
// of units/memory_timing.h. V is the Verilated class; without such pins there is nothing here.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <deque>
#include <type_traits>
#include <utility>
#include <vector>

#include "host/board/port_sram.h"
#include "units/memory_timing.h"

namespace dynrt::host {

template <class V>
inline constexpr bool kHasMemoryPins = requires(V& top) { top.memory_read_valid_o; };

template <class V>
class NoPinMemory {
 public:
  void set_timing(const MemoryTiming& /*timing*/) {}
  void restart() {}
  void sample(const V& /*top*/, Sram& /*sram*/) {}
  void drive(V& /*top*/) const {}
};

template <class V>
class PinMemory {
 public:
  explicit PinMemory(const MemoryTiming& timing = {}) : timing_(timing) {}

  void set_timing(const MemoryTiming& timing) {
    timing_ = timing;
    restart();
  }
  /// Closes all rows and forgets all reads, as before a frame.
  void restart() { *this = PinMemory(timing_); }

  /// What the pins ask for in a clock.
  void sample(const V& top, Sram& sram) {
    if (!beats_.empty() && beats_.front().from <= now_ && top.memory_beat_ready_o) {
      beats_.pop_front();
    }
    if (top.memory_write_valid_o) write(top, sram);
    if (top.memory_read_valid_o) {
      const unsigned beats = top.memory_read_last_o + 1u;
      const Read read{static_cast<Id>(top.memory_read_id_o), top.memory_read_address_o, beats};
      schedule_.take(now_, read.address, beats, read);
    }
    if (const auto read = schedule_.answer(now_)) answer(*read, sram);
    ++now_;
  }
  /// The pins in the next clock.
  void drive(V& top) const {
    top.memory_read_ready_i = 1;
    top.memory_write_ready_i = 1;
    top.memory_beat_valid_i = !beats_.empty() && beats_.front().from <= now_;
    if (!top.memory_beat_valid_i) return;
    top.memory_beat_id_i = beats_.front().id;
    top.memory_beat_last_i = beats_.front().last;
    std::memcpy(&top.memory_beat_data_i, beats_.front().data.data(), kBeatBytes);
  }

 private:
  using Id = std::remove_cvref_t<decltype(std::declval<V&>().memory_beat_id_i)>;
  static constexpr std::size_t kBeatBytes = sizeof(std::declval<V&>().memory_beat_data_i);
  struct Read {
    Id id;
    unsigned address;
    unsigned beats;
  };
  struct Beat {
    std::uint64_t from;  ///< the clock
    Id id;
    bool last;
    std::array<std::uint8_t, kBeatBytes> data;
  };

  void answer(const Read& read, const Sram& sram) {
    for (unsigned i = 0; i < read.beats; ++i) {
      Beat beat{now_ + 1 + i, read.id, i + 1 == read.beats, {}};
      for (unsigned b = 0; b < kBeatBytes; ++b) {
        beat.data[b] = port_byte(sram, read.address + i * static_cast<unsigned>(kBeatBytes) + b);
      }
      beats_.push_back(beat);
    }
  }
  void write(const V& top, Sram& sram) {
    schedule_.write(now_, top.memory_write_address_o);
    std::array<std::uint16_t, kBeatBytes / 2> halves;
    std::memcpy(halves.data(), &top.memory_write_data_o, kBeatBytes);
    for (unsigned h = 0; h < halves.size(); ++h) {
      if ((top.memory_write_mask_o >> h & 1) == 0) continue;
      write_port_half(sram, top.memory_write_address_o + 2 * h, halves[h]);
    }
  }

  MemoryTiming timing_;
  MemorySchedule<Read> schedule_{timing_};
  std::deque<Beat> beats_;
  std::uint64_t now_ = 0;
};

template <class V>
using MemoryAtPins = std::conditional_t<kHasMemoryPins<V>, PinMemory<V>, NoPinMemory<V>>;

}  // namespace dynrt::host
