// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The memory behind the port of the native core: the words of the scene's banks, as they lie there
// (units/memory_format.h), at the clocks of an emulated memory (units/memory_timing.h).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "hls/device.h"
#include "hls/fifo.h"
#include "units/memory_port.h"
#include "units/memory_timing.h"

namespace dynrt {

template <class C>
class PortMemory final : public hls::Device {
 public:
  using Reads = std::shared_ptr<hls::Fifo<PortRead<C>>>;
  using Beats = std::shared_ptr<hls::Fifo<PortBeat<C>>>;
  using Banks = std::array<hls::Rows<SceneWord<typename C::Real>>, kSceneBanks>;

  PortMemory(Reads reads, Beats beats, const Banks& banks, const MemoryTiming& timing)
      : schedule_(timing), reads_(std::move(reads)), beats_(std::move(beats)), banks_(banks) {}

  void take(std::uint64_t now) override {
    taken_.push_back(reads_->pop());
    const PortRead<C>& read = taken_.back();
    schedule_.take(now, static_cast<unsigned>(read.address.to_u64()), beats_of(read));
  }
  std::size_t answer(std::uint64_t now) override {
    const auto number = schedule_.answer(now);
    if (!number) return 0;
    const PortRead<C> read = taken_[*number];
    const unsigned beats = beats_of(read);
    for (unsigned i = 0; i < beats; ++i) {
      const auto byte = static_cast<unsigned>(read.address.to_u64()) + i * kBeatBytes<C>;
      beats_->push(PortBeat<C>{read.id, data_at(byte), i + 1 == beats});
    }
    return beats;
  }
  std::uint64_t next() const override {
    return schedule_.is_idle() ? hls::kNever : schedule_.next();
  }

 private:
  static unsigned beats_of(const PortRead<C>& read) {
    return static_cast<unsigned>(read.last.to_u64()) + 1;
  }
  BeatData<C> data_at(unsigned byte) const {
    BeatData<C> data;
    for (uint<16>& half : data) {
      half = uint<16>::from(word(byte / 4) >> (8 * (byte % 4)));
      byte += 2;
    }
    return data;
  }
  std::uint64_t word(unsigned port_word) const {
    const BankWord at = bank_word(port_word);
    return at.bank == kSceneBanks ? 0 : banks_[at.bank][at.word].to_u64();
  }

  MemorySchedule schedule_;
  Reads reads_;
  Beats beats_;
  const Banks& banks_;
  std::vector<PortRead<C>> taken_;
};

}  // namespace dynrt
