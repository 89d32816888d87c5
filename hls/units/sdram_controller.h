// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The controller of an SDR SDRAM: a transaction is a clock. It sets the chip up, refreshes it, and
// keeps rows open. Each bank has a queue of bursts, done in their order, and its row is opened
// while words of other banks are on their way; of the banks that are ready, one after the other
// moves a burst, reads after reads and writes after writes where there is a choice. So bursts to
// one place keep their order, others may not. Clocks go in turns of two: in the first a column
// command may be given, which moves a pair of words, in the second a row command. So column
// commands back to back keep the data bus busy and leave every other clock for rows, and each step
// of a decision has a clock of its own. Data do not pass through here: a token says what the data
// pins are to do (rtl/sdram/sdram_port.v). S is a part and a clock (units/sdram_timing.h). State:
// for each bank a queue of kSdramQueue bursts, its first one, the open row, and the turns that
// commands have to wait, as thermometers that shift; the burst that moves and the one after it.
#pragma once

#include <array>

#include "hls/cast.h"
#include "hls/ports.h"
#include "units/sdram_timing.h"
#include "units/sdram_tokens.h"

namespace dynrt {

/// Without the branch that && makes, whose multiplexer would take time in a loop of state.
template <class... Flags>
constexpr bool all(Flags... flags) {
  return (flags & ...);
}
template <class... Flags>
constexpr bool any(Flags... flags) {
  return (flags | ...);
}

/// value + one, without a carry chain: a placer tears a chain of few bits from its register.
template <unsigned W>
constexpr uint<W> add_late(uint<W> value, bool one) {
  uint<W> sum;
  bool ones = true;  // the bits below are
  for (unsigned i = 0; i < W; ++i) {
    const bool flips = all(one, ones);
    sum = sum | uint<W>::from(value.bit(i) != flips ? 1u << i : 0u);
    ones = all(ones, value.bit(i));
  }
  return sum;
}

/// Turns to wait, up to Most, as ones from bit 0.
template <unsigned Most>
class SdramWait {
 public:
  using Turns = uint<Most == 0 ? 1 : Most>;
  constexpr bool over() const { return !turns_.template bit<0>(); }
  /// After the next pass().
  constexpr bool over_next() const {
    if constexpr (Most < 2) {
      return true;
    } else {
      return !turns_.template bit<1>();
    }
  }
  template <unsigned N>
  constexpr void atleast(bool when) {
    static_assert(N <= Most);
    if (when) turns_ = turns_ | Turns::from((1u << N) - 1);
  }
  constexpr void pass() { turns_ = turns_ >> uint<1>(1); }

 private:
  Turns turns_{};
};

template <class S>
struct SdramController {
  using T = SdramTiming<S>;
  using Turn = uint<16>;

  hls::In<SdramRequest> request;
  /// Turns before the first command: SdramTiming::kPauseTurns, fewer for a simulation.
  hls::Config<Turn> pause;
  hls::Out<SdramPins> pins;
  hls::RegisterFile<SdramBurst, kSdramQueue> queue[kSdramBanks];
  HLS_PORTS(request, pause, pins)

  void step() {
    const SdramRequest r = request.read();
    // Found in both clocks of a turn, and used in the one after; so no choice delays them.
    const Flags flags = find_flags();
    const std::array<bool, kSdramBanks> picks = find_picks();
    SdramPins p;
    if (row_turn_) {
      row_turn(p);
    } else {
      column_turn(p);
    }
    uint<3> taken;
    for (unsigned i = 0; i < kSdramBanks; ++i) {
      Bank& k = banks_[i];
      const SdramBurst first = queue[i].read(k.from.template trunc<kQueueBits>());
      const bool takes = all(row_turn_, !k.valid, k.from != k.to);
      if (takes) k.first = first;
      k.from = add_late(k.from, takes);
      k.valid = any(takes, all(k.valid, any(row_turn_, !picks_[i])));
      taken = (taken + uint<1>(takes)).template trunc<3>();
      if (all(r.valid, r.burst.place.bank == uint<2>::from(i))) {
        queue[i].write(k.to.template trunc<kQueueBits>(), r.burst);
        k.to = hls::next(k.to);
      }
    }
    p.ready = setup_ == Setup::kDone;
    p.taken = taken;
    pins.write(p);
    flags_ = flags;
    picks_ = picks;
    row_turn_ = !row_turn_;
  }

 private:
  static constexpr unsigned kQueueBits = hls::index_width(kSdramQueue);
  static constexpr unsigned kMostActivate = std::max(
      {T::kActivateToActivate, T::kRefreshToActivate, T::kPrechargeToActivate, T::kModeToActivate});
  static constexpr unsigned kMostPrecharge =
      std::max({T::kActivateToPrecharge, T::kReadToPrecharge, T::kWriteToPrecharge});
  enum class Setup : unsigned char { kPause, kRefreshes, kMode, kDone };

  struct Bank {
    uint<kQueueBits + 1> from, to;  ///< of the queue
    SdramBurst first;
    bool valid = false;
    bool open = false;
    uint<kSdramRowBits> row;
    SdramWait<kMostActivate> activate;
    SdramWait<kMostPrecharge> precharge;
  };
  /// A burst on its way to the pins.
  struct Moving {
    bool valid = false;
    std::array<bool, kSdramBanks> here{};  ///< its bank
    uint<8> pair;
    uint<3> last;
    bool write = false;
    uint<5> tag;
  };

  /// What a column turn leaves to the row turn after it.
  struct Flags {
    std::array<bool, kSdramBanks> ready{};  ///< the bank's first burst may move
    std::array<bool, kSdramBanks> alike{};  ///< and goes the way of the one before
    std::array<bool, kSdramBanks> activates{};
    std::array<bool, kSdramBanks> precharges{};
    bool any_open = false;
    bool may_refresh = false;
    bool may_precharge_all = false;
    bool stop = true;        ///< no more rows and bursts: the chip is set up, or a refresh is due
    bool time_over = false;  ///< of the pause, or between two refreshes
  };
  Flags find_flags() const {
    Flags f;
    f.stop = any(due_, setup_ != Setup::kDone);
    f.may_refresh = true;
    f.may_precharge_all = all(!moving_.valid, !next_.valid);
    for (unsigned i = 0; i < kSdramBanks; ++i) {
      const Bank& k = banks_[i];
      const bool same = k.row == k.first.place.row;
      const bool used = any(all(moving_.valid, moving_.here[i]), all(next_.valid, next_.here[i]));
      f.ready[i] = all(k.valid, k.open, same, !picks_[i]);
      f.alike[i] = all(f.ready[i], k.first.write == writes_);
      f.activates[i] = all(k.valid, !k.open, k.activate.over(), !f.stop);
      f.precharges[i] = all(k.valid, k.open, !same, k.precharge.over(), !used, !picks_[i], !f.stop);
      f.any_open = any(f.any_open, k.open);
      f.may_refresh = all(f.may_refresh, !k.open, k.activate.over());
      f.may_precharge_all = all(f.may_precharge_all, k.precharge.over(), !picks_[i]);
    }
    f.time_over =
        turns_ == (setup_ == Setup::kPause ? pause.get() : Turn::from(T::kRefreshTurns - 1));
    return f;
  }

  /// The bank whose burst is the next; found in the row turn, for the column turn. Banks take
  /// turns.
  std::array<bool, kSdramBanks> find_picks() const {
    const Flags& f = flags_;
    const bool any_alike = any(f.alike[0], f.alike[1], f.alike[2], f.alike[3]);
    const bool may = all(row_turn_, !next_.valid, !f.stop);
    std::array<bool, kSdramBanks> candidates;
    for (unsigned i = 0; i < kSdramBanks; ++i) {
      candidates[i] = all(may, any_alike ? f.alike[i] : f.ready[i]);
    }
    std::array<bool, kSdramBanks> picks;
    for (unsigned i = 0; i < kSdramBanks; ++i) {
      const auto before = [&](unsigned by) { return (i + kSdramBanks - by) % kSdramBanks; };
      const bool c1 = !candidates[before(1)];
      const bool c2 = !candidates[before(2)];
      const bool c3 = !candidates[before(3)];
      picks[i] = all(candidates[i],
                     any(last_pick_[before(1)], all(last_pick_[before(2)], c1),
                         all(last_pick_[before(3)], c1, c2), all(last_pick_[i], c1, c2, c3)));
    }
    return picks;
  }

  /// A pair of the moving burst moves, and the picked burst follows.
  void column_turn(SdramPins& p) {
    const bool goes = all(moving_.valid, any(!moving_.write, write_.over()));
    const bool ends = moving_.last == uint<3>(0);
    const uint<8> pair = moving_.pair;
    p.command = !goes           ? SdramCommand::kNone
                : moving_.write ? SdramCommand::kWrite
                                : SdramCommand::kRead;
    p.bank = number_of(moving_.here);
    p.address = hls::concat(pair, uint<1>(0)).template zext<13>();
    p.reads = all(goes, !moving_.write);
    p.writes = all(goes, moving_.write);
    p.word = hls::concat(pair.template trunc<3>(), uint<1>(0));
    p.tag = moving_.tag;
    second_ = p;
    second_.last = ends;

    for (unsigned i = 0; i < kSdramBanks; ++i) {
      banks_[i].precharge.template atleast<T::kReadToPrecharge>(all(p.reads, moving_.here[i]));
      banks_[i].precharge.template atleast<T::kWriteToPrecharge>(all(p.writes, moving_.here[i]));
    }
    write_.pass();
    write_.template atleast<T::kReadToWrite>(p.reads);

    const Moving picked = picked_burst();
    const bool leaves = any(!moving_.valid, all(goes, ends));
    if (leaves) {
      moving_ = next_.valid ? next_ : picked;
      next_.valid = false;
    } else {
      if (goes) {
        moving_.pair = hls::concat(pair.template bits<7, 3>(), hls::next(pair.template trunc<3>()));
        moving_.last = (moving_.last + uint<3>::ones()).template trunc<3>();
      }
      if (picked.valid) next_ = picked;
    }
    if (picked.valid) {
      writes_ = picked.write;
      last_pick_ = picks_;
    }
  }
  Moving picked_burst() const {
    Moving m;
    m.here = picks_;
    uint<kSdramQueueWord> word;
    for (unsigned i = 0; i < kSdramBanks; ++i) {
      const SdramBurst& b = banks_[i].first;
      m.valid = any(m.valid, picks_[i]);
      const auto bits =
          hls::concat(hls::concat(b.place.pair, b.last), hls::concat(b.tag, uint<1>(b.write)));
      word = word | hls::select(picks_[i], bits, uint<kSdramQueueWord>(0));
    }
    m.pair = word.template bits<16, 9>();
    m.last = word.template bits<8, 6>();
    m.tag = word.template bits<5, 1>();
    m.write = word.template bit<0>();
    return m;
  }
  static constexpr unsigned kSdramQueueWord = 17;

  void row_turn(SdramPins& p) {
    const Flags& f = flags_;
    // The lowest bank first: one that has its row gives way.
    std::array<bool, kSdramBanks> opens;
    std::array<bool, kSdramBanks> closes;
    bool before = false;
    for (unsigned i = 0; i < kSdramBanks; ++i) {
      opens[i] = all(f.activates[i], !before);
      before = any(before, f.activates[i]);
    }
    for (unsigned i = 0; i < kSdramBanks; ++i) {
      closes[i] = all(f.precharges[i], !before);
      before = any(before, f.precharges[i]);
    }
    const bool activates = any(opens[0], opens[1], opens[2], opens[3]);
    const bool precharges = any(closes[0], closes[1], closes[2], closes[3]);
    const bool precharges_all = all(f.stop, f.any_open, f.may_precharge_all);
    const bool next_step = all(f.stop, f.may_refresh);
    const bool starts = all(next_step, setup_ == Setup::kPause, due_);
    const bool refreshes = all(next_step, any(setup_ == Setup::kRefreshes, setup_ == Setup::kDone));
    const bool sets_mode = all(next_step, setup_ == Setup::kMode);

    p = second_;
    p.command = activates                                 ? SdramCommand::kActivate
                : any(precharges, precharges_all, starts) ? SdramCommand::kPrecharge
                : refreshes                               ? SdramCommand::kRefresh
                : sets_mode                               ? SdramCommand::kMode
                                                          : SdramCommand::kNone;
    p.bank = any(opens[1], closes[1])   ? uint<2>(1)
             : any(opens[2], closes[2]) ? uint<2>(2)
             : any(opens[3], closes[3]) ? uint<2>(3)
                                        : uint<2>(0);
    uint<kSdramRowBits> row;
    for (unsigned i = 0; i < kSdramBanks; ++i) {
      row = row | hls::select(opens[i], banks_[i].first.place.row, uint<kSdramRowBits>(0));
    }
    p.address = !f.stop                  ? row
                : setup_ == Setup::kMode ? uint<13>::from(T::kModeRegister)
                                         : uint<13>(1 << 10);
    p.word = hls::concat(second_.word.template bits<3, 1>(), uint<1>(1));

    for (unsigned i = 0; i < kSdramBanks; ++i) {
      Bank& k = banks_[i];
      const bool shuts = any(closes[i], precharges_all);
      k.open = any(all(k.open, !shuts), opens[i]);
      if (opens[i]) k.row = k.first.place.row;
      k.activate.pass();
      k.precharge.pass();
      k.activate.template atleast<T::kPrechargeToActivate>(any(shuts, starts));
      k.activate.template atleast<T::kActivateToActivate>(opens[i]);
      k.activate.template atleast<T::kRefreshToActivate>(refreshes);
      k.activate.template atleast<T::kModeToActivate>(sets_mode);
      k.precharge.template atleast<T::kActivateToPrecharge>(opens[i]);
    }
    keep_time(starts, refreshes, sets_mode);
  }
  // From an activate the flag takes a clock, the pick one, the burst's way to its command three.
  static_assert(T::kActivateToColumn <= 2, "a burst moves five clocks after its activate");

  /// The setup's steps, and when the next refresh is due.
  void keep_time(bool starts, bool refreshes, bool sets_mode) {
    turns_ = flags_.time_over ? Turn(0) : hls::next(turns_);
    if (flags_.time_over) {
      due_ = true;
    } else if (refreshes) {
      due_ = false;
    }
    // Now the other way goes first, so that no burst waits for ever.
    if (refreshes) writes_ = !writes_;
    if (starts) {
      setup_ = Setup::kRefreshes;
    } else if (all(setup_ == Setup::kRefreshes, refreshes)) {
      refreshes_ = hls::next(refreshes_);
      if (refreshes_ == uint<3>(0)) setup_ = Setup::kMode;
    } else if (sets_mode) {
      setup_ = Setup::kDone;
    }
  }
  static_assert(T::kPart.first_refreshes == 8, "refreshes_ counts them");

  static uint<2> number_of(const std::array<bool, kSdramBanks>& bank) {
    return hls::concat(uint<1>(any(bank[2], bank[3])), uint<1>(any(bank[1], bank[3])));
  }

  bool row_turn_ = false;
  Bank banks_[kSdramBanks];
  Moving moving_;
  Moving next_;
  SdramWait<T::kReadToWrite> write_;
  bool writes_ = false;  ///< the last burst that was picked
  std::array<bool, kSdramBanks> last_pick_{true, false, false, false};

  Flags flags_;
  std::array<bool, kSdramBanks> picks_{};
  SdramPins second_;

  Setup setup_ = Setup::kPause;
  bool due_ = false;
  Turn turns_;
  uint<3> refreshes_;
};

}  // namespace dynrt
