// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The controller of an SDR SDRAM: a transaction is a clock. It sets the chip up, refreshes it,
// keeps rows open, and opens the row of the next burst in another bank while words of this one are
// on their way. Clocks go in turns of two: in the first a column command may be given, which moves
// a pair of words, in the second a row command. So column commands back to back keep the data bus
// busy and leave every other clock for rows. Bursts are done in their order. Data do not pass
// through here: a token says what the data pins are to do (rtl/sdram/sdram_port.v). S is a part
// and a clock (units/sdram_timing.h). State: a queue of kSdramQueue bursts, one whose row is
// prepared, two that move data; for each bank the open row and the turns that commands have to
// wait, as thermometers that shift.
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
  hls::Config<Turn>
      pause;  ///< turns before the first command: SdramTiming::kPauseTurns, less for a simulation
  hls::Out<SdramPins> pins;
  hls::RegisterFile<SdramBurst, kSdramQueue> queue;
  HLS_PORTS(request, pause, pins)

  void step() {
    const bool takes = !row_turn_ && !ahead_valid_ && head_ != tail_;
    const SdramBurst first = queue.read(head_.template trunc<kQueueBits>());
    const SdramRequest r = request.read();
    if (r.valid) {
      queue.write(tail_.template trunc<kQueueBits>(), r.burst);
      tail_ = hls::next(tail_);
    }
    SdramPins p;
    // Found in both clocks of a turn, and used in the one after; so no choice delays them.
    const Flags flags = find_flags();
    const bool goes = next_goes();
    if (row_turn_) {
      row_turn(p);
    } else {
      column_turn(p);
      if (takes) {
        ahead_ = first;
        ahead_valid_ = true;
        head_ = hls::next(head_);
      }
    }
    p.ready = setup_ == Setup::kDone;
    p.taken = takes;
    pins.write(p);
    flags_ = flags;
    goes_ = goes;
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
    bool open = false;
    uint<kSdramRowBits> row;
    SdramWait<T::kActivateToColumn> column;
    SdramWait<kMostActivate> activate;
    SdramWait<kMostPrecharge> precharge;
  };

  /// A pair of the first burst moves, and the flags of the next row turn are found.
  void column_turn(SdramPins& p) {
    const bool goes = goes_;
    SdramBurst& b = moving_[0].burst;
    const uint<8> pair = b.place.pair;
    p.command = !goes ? SdramCommand::kNone : b.write ? SdramCommand::kWrite : SdramCommand::kRead;
    p.bank = b.place.bank;
    p.address = hls::concat(pair, uint<1>(0)).template zext<13>();
    p.reads = goes && !b.write;
    p.writes = goes && b.write;
    p.word = hls::concat(pair.template trunc<3>(), uint<1>(0));
    const bool ends = b.last == uint<3>(0);
    second_reads_ = p.reads;
    second_writes_ = p.writes;
    second_pair_ = pair.template trunc<3>();
    second_last_ = ends;

    for (unsigned i = 0; i < kSdramBanks; ++i) {
      const bool here = moving_[0].here[i];
      banks_[i].column.pass();
      banks_[i].precharge.template atleast<T::kReadToPrecharge>(p.reads && here);
      banks_[i].precharge.template atleast<T::kWriteToPrecharge>(p.writes && here);
    }
    write_.pass();
    write_.template atleast<T::kReadToWrite>(p.reads);
    if (goes) {
      if (ends) {
        moving_[0] = moving_[1];
        moving_[1].valid = false;
      } else {
        b.place.pair = hls::concat(pair.template bits<7, 3>(), hls::next(pair.template trunc<3>()));
        b.last = (b.last + uint<3>::ones()).template trunc<3>();
      }
    }
  }

  /// What a column turn leaves to the row turn after it, which has time for little more than a
  /// choice.
  struct Flags {
    bool hit[2] = {};         ///< the prepared burst's row is open, in the lower or the upper banks
    bool room = false;        ///< it may go on, once its row is open
    bool may_follow = false;  ///< its bank's row may be used in the next column turn
    bool may_activate = false;   ///< its bank is closed, and has been for long enough
    bool may_precharge = false;  ///< its bank is open, and no burst needs it any more
    bool any_open = false;
    bool may_refresh = false;
    bool may_precharge_all = false;
    bool stop = true;         ///< no more rows: the chip is set up, or a refresh is due
    bool first_free = false;  ///< the moving burst may go on
    bool time_over = false;   ///< of the pause, or between two refreshes
  };
  Flags find_flags() const {
    const Placed& b = prepared_;
    const auto follows = [this](const Placed& of) {
      return of_bank(of, [](const Bank& k) { return k.column.over_next(); });
    };
    const auto hits = [this, &b](unsigned bank) {
      const Bank& k = banks_[bank];
      return all(b.here[bank], k.open, k.row == b.burst.place.row);
    };
    Flags f;
    f.stop = any(due_, setup_ != Setup::kDone);
    const bool ready = all(b.valid, !f.stop);
    const bool leaves = all(goes_, moving_[0].burst.last == uint<3>(0));
    f.hit[0] = any(hits(0), hits(1));
    f.hit[1] = any(hits(2), hits(3));
    f.room = all(ready, any(!moving_[1].valid, leaves));
    f.first_free = goes_ ? any(!leaves, follows(moving_[1])) : follows(moving_[0]);
    f.may_follow = follows(b);
    f.may_activate = of_bank(b, [](const Bank& k) { return all(!k.open, k.activate.over()); });
    f.may_precharge =
        all(ready, of_bank(b, [](const Bank& k) { return all(k.open, k.precharge.over()); }),
            !same_bank(moving_[0], b), !same_bank(moving_[1], b));
    f.may_refresh = true;
    f.may_precharge_all = !moving_[0].valid;
    for (const Bank& k : banks_) {
      f.any_open = any(f.any_open, k.open);
      f.may_refresh = all(f.may_refresh, !k.open, k.activate.over());
      f.may_precharge_all = all(f.may_precharge_all, k.precharge.over());
    }
    f.time_over =
        turns_ == (setup_ == Setup::kPause ? pause.get() : Turn::from(T::kRefreshTurns - 1));
    return f;
  }
  /// Whether a pair moves in the next column turn; found in the row turn.
  bool next_goes() const {
    const bool follows = all(flags_.room, any(flags_.hit[0], flags_.hit[1]), flags_.may_follow);
    const bool writes = moving_[0].valid ? moving_[0].burst.write : prepared_.burst.write;
    return all(moving_[0].valid ? flags_.first_free : follows, any(write_.over(), !writes));
  }

  void row_turn(SdramPins& p) {
    const Flags& f = flags_;
    const bool hit = any(f.hit[0], f.hit[1]);
    const bool passes = all(f.room, any(hit, f.may_activate));
    const bool activates = all(f.room, f.may_activate);
    const bool precharges = all(f.may_precharge, !hit);
    const bool precharges_all = all(f.stop, f.any_open, f.may_precharge_all);
    const bool next_step = all(f.stop, f.may_refresh);
    const bool starts = all(next_step, setup_ == Setup::kPause, due_);
    const bool refreshes = all(next_step, any(setup_ == Setup::kRefreshes, setup_ == Setup::kDone));
    const bool sets_mode = all(next_step, setup_ == Setup::kMode);

    p.command = activates                                ? SdramCommand::kActivate
                : precharges || precharges_all || starts ? SdramCommand::kPrecharge
                : refreshes                              ? SdramCommand::kRefresh
                : sets_mode                              ? SdramCommand::kMode
                                                         : SdramCommand::kNone;
    const SdramPlace& place = prepared_.burst.place;
    p.bank = flags_.stop ? uint<2>(0) : place.bank;
    p.address = !flags_.stop             ? (precharges ? uint<13>(0) : place.row)
                : setup_ == Setup::kMode ? uint<13>::from(T::kModeRegister)
                                         : uint<13>(1 << 10);
    p.reads = second_reads_;
    p.writes = second_writes_;
    p.word = hls::concat(second_pair_, uint<1>(1));
    p.last = second_last_;

    for (unsigned i = 0; i < kSdramBanks; ++i) {
      Bank& k = banks_[i];
      const bool here = prepared_.here[i];
      const bool opens = all(activates, here);
      const bool closes = any(all(precharges, here), precharges_all);
      k.open = any(all(k.open, !closes), opens);
      if (opens) k.row = place.row;
      k.activate.pass();
      k.precharge.pass();
      k.activate.template atleast<T::kPrechargeToActivate>(any(closes, starts));
      k.activate.template atleast<T::kActivateToActivate>(opens);
      k.activate.template atleast<T::kRefreshToActivate>(refreshes);
      k.activate.template atleast<T::kModeToActivate>(sets_mode);
      k.precharge.template atleast<T::kActivateToPrecharge>(opens);
      k.column.template atleast<T::kActivateToColumn>(opens);
    }
    if (passes) moving_[moving_[0].valid ? 1 : 0] = prepared_;
    if (passes || !prepared_.valid) {
      prepared_ = placed(ahead_, ahead_valid_);
      ahead_valid_ = false;
    }
    keep_time(starts, refreshes, sets_mode);
  }

  /// The setup's steps, and when the next refresh is due.
  void keep_time(bool starts, bool refreshes, bool sets_mode) {
    turns_ = flags_.time_over ? Turn(0) : hls::next(turns_);
    if (flags_.time_over) {
      due_ = true;
    } else if (refreshes) {
      due_ = false;
    }
    if (starts) {
      setup_ = Setup::kRefreshes;
    } else if (setup_ == Setup::kRefreshes && refreshes) {
      refreshes_ = hls::next(refreshes_);
      if (refreshes_ == uint<3>(0)) setup_ = Setup::kMode;
    } else if (sets_mode) {
      setup_ = Setup::kDone;
    }
  }
  static_assert(T::kPart.first_refreshes == 8, "refreshes_ counts them");

  /// A burst and its bank, one bit for each bank.
  struct Placed {
    SdramBurst burst;
    bool here[kSdramBanks] = {};
    bool valid = false;
  };
  static Placed placed(const SdramBurst& burst, bool valid) {
    Placed p{.burst = burst, .valid = valid};
    for (unsigned i = 0; i < kSdramBanks; ++i) p.here[i] = burst.place.bank == uint<2>::from(i);
    return p;
  }
  /// A flag of the burst's bank.
  template <class Flag>
  bool of_bank(const Placed& b, Flag flag) const {
    return any(all(b.here[0], flag(banks_[0])), all(b.here[1], flag(banks_[1])),
               all(b.here[2], flag(banks_[2])), all(b.here[3], flag(banks_[3])));
  }
  /// Whether a row command for `b` would disturb a burst that moves.
  static bool same_bank(const Placed& moving, const Placed& b) {
    return all(moving.valid, moving.burst.place.bank == b.burst.place.bank);
  }

  bool row_turn_ = false;
  uint<kQueueBits + 1> head_;
  uint<kQueueBits + 1> tail_;

  SdramBurst ahead_;
  bool ahead_valid_ = false;
  Placed prepared_;
  Placed moving_[2];
  Bank banks_[kSdramBanks];
  SdramWait<T::kReadToWrite> write_;

  bool goes_ = false;  ///< a pair moves in the next column turn
  Flags flags_;
  bool second_reads_ = false;
  bool second_writes_ = false;
  uint<3> second_pair_;
  bool second_last_ = false;

  Setup setup_ = Setup::kPause;
  bool due_ = false;
  Turn turns_;
  uint<3> refreshes_;
};

}  // namespace dynrt
