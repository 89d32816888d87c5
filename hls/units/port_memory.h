// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The memory behind the port of the native core: the words of the banks, as they lie there
// (units/memory_format.h), at the clocks of an emulated memory (units/memory_timing.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "hls/device.h"
#include "hls/fifo.h"
#include "units/banks.h"
#include "units/memory_port.h"
#include "units/memory_timing.h"

namespace dynrt {

template <class C>
class PortMemory final : public hls::Device {
 public:
  using Reads = std::shared_ptr<hls::Fifo<PortRead<C>>>;
  using Beats = std::shared_ptr<hls::Fifo<PortBeat<C>>>;
  using Writes = std::shared_ptr<hls::Fifo<PortWrite<C>>>;

  PortMemory(Reads reads, Beats beats, Writes writes, Banks<C>& banks, const MemoryTiming& timing)
      : schedule_(timing),
        reads_(std::move(reads)),
        beats_(std::move(beats)),
        writes_(std::move(writes)),
        banks_(banks) {}

  void take(std::uint64_t now) override {
    const PortRead<C> read = reads_->pop();
    schedule_.take(now, byte_of(read.address), beats_of(read), read);
  }
  void take_write(std::uint64_t now) override {
    const PortWrite<C> write = writes_->pop();
    schedule_.write(now, byte_of(write.address));
    for (unsigned i = 0; i < write.data.size(); ++i) {
      if ((write.mask.to_u64() >> i & 1) == 0) continue;
      banks_.write_half(byte_of(write.address) + 2 * i, write.data[i]);
    }
  }
  std::size_t answer(std::uint64_t now) override {
    const std::optional<PortRead<C>> read = schedule_.answer(now);
    if (!read) return 0;
    const unsigned beats = beats_of(*read);
    for (unsigned i = 0; i < beats; ++i) {
      const unsigned byte = byte_of(read->address) + i * kBeatBytes<C>;
      beats_->push(PortBeat<C>{read->id, data_at(byte), i + 1 == beats});
    }
    return beats;
  }
  std::uint64_t next() const override {
    return schedule_.is_idle() ? hls::kNever : schedule_.next();
  }

 private:
  static unsigned byte_of(const auto& address) { return static_cast<unsigned>(address.to_u64()); }
  static unsigned beats_of(const PortRead<C>& read) {
    return static_cast<unsigned>(read.last.to_u64()) + 1;
  }
  BeatData<C> data_at(unsigned byte) const {
    BeatData<C> data;
    for (uint<16>& half : data) {
      const BankWord at = bank_word(byte);
      const std::uint64_t word = at.bank == kBanks ? 0 : banks_.scene.at(at.bank)[at.word].to_u64();
      half = uint<16>::from(word >> (8 * (byte % 4)));
      byte += 2;
    }
    return data;
  }

  MemorySchedule<PortRead<C>> schedule_;
  Reads reads_;
  Beats beats_;
  Writes writes_;
  Banks<C>& banks_;
};

}  // namespace dynrt
