// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The activity of the units over the clocks of a frame that is watched: the work and the waits of
// each unit in each part of the frame, and the fill of the FIFOs between units
// (units/frame_watch.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "hls/join.h"
#include "units/frame_watch.h"

namespace dynrt {

class UnitActivity : public hls::ClockWatch {
 public:
  /// Watches FIFOs if parts are wanted.
  UnitActivity(hls::Join& join, FrameWatch& watch) : watch_(watch) {
    watch.part_clocks = 1;
    watch.work.assign(watch.units.size(), std::vector<std::uint32_t>(watch.parts));
    watch.fifos.clear();
    watch.waits.clear();
    if (watch.parts == 0) return;
    for (const hls::FifoRecord& fifo : join.fifos()) {
      watch.fifos.push_back({fifo.channel, fifo.port, fifo.depth});
    }
    leaving_.resize(watch.fifos.size());
    waits_of_.resize(watch.units.size());
    join.watch_clocks(*this);
  }

  /// A unit makes a transaction.
  void works(std::size_t unit, std::uint64_t clock) {
    if (watch_.parts > 0) ++watch_.work[unit][part_of(clock)];
  }

  void waited(std::size_t unit, std::size_t fifo, hls::Lack lack, std::uint64_t from,
              std::uint64_t to) override {
    const std::size_t wait = place_of(unit, fifo, lack == hls::Lack::kRoom);
    part_of(to - 1);
    while (from < to) {
      const std::uint64_t part = part_of(from);
      const std::uint64_t end = std::min(to, (part + 1) * watch_.part_clocks);
      watch_.waits[wait].clocks[part] += static_cast<std::uint32_t>(end - from);
      from = end;
    }
  }

  void passed(std::size_t fifo, std::uint64_t from, std::uint64_t to) override {
    WatchedFifo& seen = watch_.fifos[fifo];
    ++seen.tokens;
    seen.clocks += to - from + 1;
    // Earlier tokens that leave at or after `from` were still there when this token came.
    std::deque<std::uint64_t>& leaving = leaving_[fifo];
    while (!leaving.empty() && leaving.front() < from) leaving.pop_front();
    leaving.push_back(to);
    seen.most = std::max(seen.most, leaving.size());
  }

 private:
  /// The parts grow with the frame, as its length is not known before its end.
  std::uint64_t part_of(std::uint64_t clock) {
    while (clock / watch_.part_clocks >= watch_.parts) double_parts();
    return clock / watch_.part_clocks;
  }

  void double_parts() {
    const auto pair_up = [half = watch_.parts / 2](std::vector<std::uint32_t>& counts) {
      for (unsigned i = 0; i < half; ++i) counts[i] = counts[2 * i] + counts[2 * i + 1];
      std::fill(counts.begin() + half, counts.end(), 0);
    };
    for (std::vector<std::uint32_t>& work : watch_.work) pair_up(work);
    for (WatchedWait& wait : watch_.waits) pair_up(wait.clocks);
    watch_.part_clocks *= 2;
  }

  /// The place of a wait in the list of waits.
  std::size_t place_of(std::size_t unit, std::size_t fifo, bool for_room) {
    for (const std::size_t place : waits_of_[unit]) {
      const WatchedWait& wait = watch_.waits[place];
      if (wait.fifo == fifo && wait.for_room == for_room) return place;
    }
    watch_.waits.push_back({unit, fifo, for_room, std::vector<std::uint32_t>(watch_.parts)});
    waits_of_[unit].push_back(watch_.waits.size() - 1);
    return watch_.waits.size() - 1;
  }

  FrameWatch& watch_;
  std::vector<std::deque<std::uint64_t>> leaving_;  ///< by FIFO, the last clocks of its last tokens
  std::vector<std::vector<std::size_t>> waits_of_;  ///< by unit, places in the list of waits
};

}  // namespace dynrt
