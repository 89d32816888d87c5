// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The SDRAM behind the port of the native core: the models of the controller and of the chip at
// their clock, the core at its own, a crossing of some clocks each way, and a display that reads
// its picture all the while.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "hls/cast.h"
#include "hls/device.h"
#include "hls/fifo.h"
#include "sdram/sdram_bench.h"
#include "units/banks.h"
#include "units/memory_port.h"

namespace dynrt::verif {

struct SdramSystem {
  double core_nanoseconds = 0;  ///< of a clock
  double display_bytes = 0;     ///< that the display reads in a second
};

/// What a frame asked of it.
struct SdramUse {
  SdramCounters chip;
  std::uint64_t core_reads = 0;  ///< bytes
  /// Of those, by the place of a read's first byte: nodes, entries of lists, columns of matrices.
  std::array<std::uint64_t, 3> core_reads_of{};
  std::uint64_t core_writes = 0;
  std::uint64_t display_reads = 0;
  double read_nanoseconds = 0;  ///< of all reads of the core, from port to port
  std::uint64_t reads = 0;
  std::uint64_t bursts = 0;        ///< of the core and of the display
  std::uint64_t late_display = 0;  ///< reads that were not done before the next was due
  std::uint64_t idle_clocks = 0;  ///< of the chip, in which nothing moved and no read was under way
};

template <class C, class S>
class SdramMemory final : public hls::Device {
 public:
  static constexpr unsigned kBytes = kBeatBytes<C>;
  static constexpr unsigned kCrossing = 4;  ///< clocks of the side that a token comes to
  static constexpr unsigned kOnWay = 1;     ///< clock of the SDRAM in a buffer, each way
  static constexpr unsigned kAtSwitch = 1;  ///< clock of the core in a buffer, on the way back
  using Types = SdramPortTypes<kBytes>;
  using Reads = std::shared_ptr<hls::Fifo<PortRead<C>>>;
  using Beats = std::shared_ptr<hls::Fifo<PortBeat<C>>>;
  using Writes = std::shared_ptr<hls::Fifo<PortWrite<C>>>;

  /// The scene is written straight into the chip's model. `use` gets the requests of the frame.
  SdramMemory(Reads reads, Beats beats, Writes writes, Banks<C>& banks, const SdramSystem& system,
              unsigned stages, SdramBench<kBytes>& bench, SdramUse& use)
      : reads_(std::move(reads)),
        beats_(std::move(beats)),
        writes_(std::move(writes)),
        banks_(banks),
        system_(system),
        port_(stages, kPauseTurns),
        bench_(bench),
        use_(use) {
    load();
    while (!bench_.chip().is_set_up()) bench_.clock(port_, traffic_);
    bench_.chip().clear_counters();
  }
  ~SdramMemory() override { use_.chip = bench_.chip().counters(); }
  SdramMemory(const SdramMemory&) = delete;
  SdramMemory& operator=(const SdramMemory&) = delete;

  static constexpr unsigned kPauseTurns = 100;

  void take(std::uint64_t now) override {
    waiting_reads_.push_back({arrival(now), reads_->pop()});
    ++reads_under_way_;
  }
  void take_write(std::uint64_t now) override {
    const PortWrite<C> write = writes_->pop();
    store(write);
    waiting_writes_.push_back({arrival(now), write});
  }
  std::size_t answer(std::uint64_t now) override {
    now_ = now;
    advance(static_cast<double>(now) * system_.core_nanoseconds);
    if (answers_.empty() || answers_.front().first > now) return 0;
    beats_->push(answers_.front().second);
    answers_.pop_front();
    return 1;
  }
  std::uint64_t next() const override {
    const bool idle = reads_under_way_ == 0 && answers_.empty() && waiting_writes_.empty();
    return idle ? hls::kNever : now_ + 1;
  }

 private:
  static constexpr double kClock = S::kClockPicoseconds / 1000.;
  static constexpr double kToPort = (kCrossing + kOnWay) * kClock;
  static constexpr std::uint32_t kDisplay = 1u << 31;  ///< in a read's id
  static constexpr std::uint32_t kPictureBytes = 640 * 480 * 2;

  double arrival(std::uint64_t now) const {
    return static_cast<double>(now + 1) * system_.core_nanoseconds + kToPort;
  }
  void advance(double until) {
    for (; time_ <= until; time_ += kClock) {
      const std::uint64_t words = bench_.chip().counters().busy();
      bench_.clock(port_, traffic_);
      if (bench_.is_idle() && bench_.chip().counters().busy() == words) ++use_.idle_clocks;
      if (const auto beat = bench_.last_beat()) arrive(*beat);
    }
  }
  void arrive(const typename Types::Beat& beat) {
    if ((beat.id & kDisplay) != 0) return;
    PortBeat<C> out;
    out.id = hls::from_bits<PortId<C>>(uint<hls::bit_width_of<PortId<C>>()>::from(beat.id));
    for (unsigned i = 0; i < out.data.size(); ++i) out.data[i] = uint<16>::from(beat.data[i]);
    out.last = beat.last;
    const double leaves = time_ + kOnWay * kClock;
    const auto clock =
        static_cast<std::uint64_t>(leaves / system_.core_nanoseconds) + kCrossing + kAtSwitch;
    answers_.push_back({clock, out});
    if (!beat.last) return;
    --reads_under_way_;
    const auto sent = sent_.find(beat.id);
    use_.read_nanoseconds += static_cast<double>(clock) * system_.core_nanoseconds - sent->second;
    sent_.erase(sent);
  }

  std::optional<typename Types::Read> next_read() {
    if (system_.display_bytes > 0 && time_ >= display_due_) {
      display_due_ += 32 / system_.display_bytes * 1e9;
      if (time_ >= display_due_) ++use_.late_display;
      use_.display_reads += 32;
      ++use_.bursts;
      display_ = (display_ + 32) % kPictureBytes;
      return typename Types::Read{kDisplay | display_, kPixelsAt + kPixelsAt / 4 + display_,
                                  32 / kBytes - 1};
    }
    if (waiting_reads_.empty() || waiting_reads_.front().first > time_) return std::nullopt;
    const auto [sent, read] = waiting_reads_.front();
    waiting_reads_.pop_front();
    const auto id = static_cast<std::uint32_t>(hls::to_bits(read.id).to_u64());
    sent_[id] = sent - kToPort;
    const auto last = static_cast<unsigned>(read.last.to_u64());
    const auto address = static_cast<std::uint32_t>(read.address.to_u64());
    use_.core_reads += (last + 1) * kBytes;
    use_.core_reads_of[address < kEntriesAt   ? 0
                       : address < kColumnsAt ? 1
                                              : 2] += (last + 1) * kBytes;
    ++use_.reads;
    ++use_.bursts;
    return typename Types::Read{id, address, last};
  }
  std::optional<typename Types::Write> next_write() {
    if (waiting_writes_.empty() || waiting_writes_.front().first > time_) return std::nullopt;
    const PortWrite<C> write = waiting_writes_.front().second;
    waiting_writes_.pop_front();
    typename Types::Write w;
    w.address = static_cast<std::uint32_t>(write.address.to_u64());
    w.mask = static_cast<std::uint32_t>(write.mask.to_u64());
    for (unsigned i = 0; i < w.data.size(); ++i) {
      w.data[i] = static_cast<std::uint16_t>(write.data[i].to_u64());
    }
    if (w.mask != 0) ++use_.bursts;
    use_.core_writes += 2 * static_cast<unsigned>(std::popcount(w.mask));
    return w;
  }

  void load() {
    for (std::uint32_t byte = 0; byte < kPixelsAt; byte += 4) {
      const BankWord at = bank_word(byte);
      if (at.bank >= kSceneBanks) continue;
      const auto word = static_cast<std::uint32_t>(banks_.scene[at.bank][at.word].to_u64());
      bench_.set_half(byte / 2, static_cast<std::uint16_t>(word));
      bench_.set_half(byte / 2 + 1, static_cast<std::uint16_t>(word >> 16));
    }
  }
  /// In the banks too, from which the frame is read back.
  void store(const PortWrite<C>& write) {
    for (unsigned i = 0; i < write.data.size(); ++i) {
      if ((write.mask.to_u64() >> i & 1) == 0) continue;
      banks_.write_half(static_cast<unsigned>(write.address.to_u64()) + 2 * i, write.data[i]);
    }
  }

  Reads reads_;
  Beats beats_;
  Writes writes_;
  Banks<C>& banks_;
  SdramSystem system_;
  SdramPort<S, kBytes> port_;
  SdramBench<kBytes>& bench_;
  SdramUse& use_;
  SdramTraffic<kBytes> traffic_{.read = [this] { return next_read(); },
                                .write = [this] { return next_write(); }};

  double time_ = 0;  ///< of the next clock of the chip, in ns
  double display_due_ = 0;
  std::uint32_t display_ = 0;
  std::uint64_t now_ = 0;
  std::uint64_t reads_under_way_ = 0;
  std::deque<std::pair<double, PortRead<C>>> waiting_reads_;
  std::deque<std::pair<double, PortWrite<C>>> waiting_writes_;
  std::unordered_map<std::uint32_t, double> sent_;  ///< by the read's id
  std::deque<std::pair<std::uint64_t, PortBeat<C>>> answers_;
};

}  // namespace dynrt::verif
