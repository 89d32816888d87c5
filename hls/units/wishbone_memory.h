// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The native twin of rtl/bus/wishbone_memory.v, clock by clock: the core's memory port on one side,
// a Wishbone B4 bus, pipelined, on the other. outputs() are those of a clock, clock() its rising
// edge. Which of a read and a write goes first is decided by the access before; before the first
// access the Verilog holds anything, this twin a read.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "units/port_items.h"

namespace dynrt {

/// A beat has Bytes bytes, 4 to 32.
template <unsigned Bytes>
struct WishboneMemoryTypes {
  static_assert(Bytes >= 4 && Bytes % 4 == 0);
  using Data = std::array<std::uint32_t, Bytes / 4>;
  using Read = typename PortItems<Data>::Read;
  using Write = typename PortItems<Data>::Write;
  using Beat = typename PortItems<Data>::Beat;
  struct Inputs {
    bool stop = false;
    std::optional<Read> read;
    std::optional<Write> write;
    bool beat_ready = true;
    bool stall = false;
    bool ack = false;
    bool err = false;
    Data data{};
  };
  struct Access {
    bool write = false;
    std::uint32_t address = 0;  ///< in the core's memory
    Data data{};                ///< of a write
    std::uint32_t mask = 0;
    friend bool operator==(const Access&, const Access&) = default;
  };
  struct Error {
    bool write = false;
    std::uint32_t address = 0;
    friend bool operator==(const Error&, const Error&) = default;
  };
  struct Outputs {
    bool idle = true;
    bool read_ready = false;
    bool write_ready = false;
    std::optional<Beat> beat;
    bool cycle = false;
    std::optional<Access> access;
    std::optional<Error> error;
    friend bool operator==(const Outputs&, const Outputs&) = default;
  };
};

/// `Flight` accesses in flight and beats that wait; `Turn` accesses in a row.
template <unsigned Bytes, unsigned Flight, unsigned Turn>
class WishboneMemory {
 public:
  using Types = WishboneMemoryTypes<Bytes>;
  using Inputs = typename Types::Inputs;
  using Outputs = typename Types::Outputs;

  Outputs outputs(const Inputs& in) const {
    Outputs out;
    out.idle = reads_.empty() && writes_.empty() && flight_.empty() && beats_.empty();
    out.read_ready = reads_.size() < kBufferedTokens;
    out.write_ready = writes_.size() < kBufferedTokens;
    if (!beats_.empty() && !in.stop) out.beat = beats_.front();
    out.cycle = !flight_.empty();
    out.access = access_;
    out.error = error_;
    return out;
  }

  void clock(const Inputs& in) {
    const Outputs out = outputs(in);
    const bool free = (!access_ || !in.stall) && flight_.size() < Flight && !rests_;
    const bool write_asks = !writes_.empty() && writes_.front().mask != 0;
    const bool read_asks = !reads_.empty() && credits_ > 0;
    const bool write_goes = free && write_asks && (write_first_ || !read_asks);
    const bool read_goes = free && read_asks && !write_goes;
    const bool beat_taken = !beats_.empty() && (in.beat_ready || in.stop);
    if (beat_taken) beats_.pop_front();
    count_turn(write_goes || read_goes);
    take_answer(in);
    if (!in.stall) access_.reset();
    if (write_goes) {
      go({.write = true,
          .address = writes_.front().address,
          .data = writes_.front().data,
          .mask = writes_.front().mask},
         {});
    }
    if (write_goes || !write_asks) pop(writes_);
    if (read_goes) go_read();
    credits_ += (beat_taken ? 1 : 0) - (read_goes ? 1 : 0);
    if (in.read && !in.stop && out.read_ready) reads_.push_back(*in.read);
    if (in.write && !in.stop && out.write_ready) writes_.push_back(*in.write);
  }

 private:
  static constexpr std::uint32_t kAll = static_cast<std::uint32_t>((1ull << (Bytes / 2)) - 1);
  struct Sent {
    typename Types::Access access;
    typename Types::Beat beat;  ///< of a read
  };

  template <class Item>
  static void pop(std::deque<Item>& items) {
    if (!items.empty()) items.pop_front();
  }
  void go(const typename Types::Access& access, const typename Types::Beat& beat) {
    access_ = access;
    flight_.push_back({access, beat});
    write_first_ = !access.write;
  }
  void go_read() {
    const typename Types::Read& read = reads_.front();
    const bool ends = beat_ == read.last;
    go({.write = false, .address = read.address + beat_ * Bytes, .data = {}, .mask = kAll},
       {.id = read.id, .data = {}, .last = ends});
    beat_ = ends ? 0 : beat_ + 1;
    if (ends) reads_.pop_front();
  }
  /// After Turn accesses the bus rests until nothing is in flight.
  void count_turn(bool goes) {
    if (goes) {
      if (++turn_ == Turn) rests_ = true;
    } else if (flight_.empty()) {
      turn_ = 0;
      rests_ = false;
    }
  }
  void take_answer(const Inputs& in) {
    error_.reset();
    if (!in.ack && !in.err) return;
    const Sent sent = flight_.front();
    flight_.pop_front();
    if (in.err) error_ = {.write = sent.access.write, .address = sent.access.address};
    if (sent.access.write) return;
    typename Types::Beat beat = sent.beat;
    beat.data = in.data;
    if (in.err) beat.data = filling_of<typename Types::Data>(beat.id);
    beats_.push_back(beat);
  }

  std::deque<typename Types::Read> reads_;
  std::deque<typename Types::Write> writes_;
  std::deque<Sent> flight_;
  std::deque<typename Types::Beat> beats_;
  std::optional<typename Types::Access> access_;  ///< at the pins
  std::optional<typename Types::Error> error_;
  bool write_first_ = false;
  bool rests_ = false;
  unsigned beat_ = 0;  ///< of the read that goes
  unsigned turn_ = 0;
  int credits_ = Flight;
};

}  // namespace dynrt
