// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The native twin of rtl/bus/axi_memory.v, clock by clock: the core's memory port on one side, AXI4
// (IHI 0022) on the other. outputs() are those of a clock, clock() its rising edge.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "units/port_items.h"

namespace dynrt {

/// A beat has Bytes bytes, 4 to 32.
template <unsigned Bytes>
struct AxiMemoryTypes {
  static_assert(Bytes >= 4 && Bytes % 4 == 0);
  using Data = std::array<std::uint32_t, Bytes / 4>;
  using Read = typename PortItems<Data>::Read;
  using Write = typename PortItems<Data>::Write;
  using Beat = typename PortItems<Data>::Beat;
  /// On the bus.
  struct Answer {
    std::uint32_t id = 0;  ///< where reads have ids of their own
    Data data{};
    unsigned response = 0;
    bool last = false;
  };
  struct Burst {
    std::uint32_t address = 0;  ///< in the core's memory
    unsigned last = 0;
    friend bool operator==(const Burst&, const Burst&) = default;
  };
  struct Word {
    Data data{};
    std::uint32_t mask = 0;
    bool last = false;
    friend bool operator==(const Word&, const Word&) = default;
  };
  struct Error {
    bool write = false;
    unsigned response = 0;
    std::uint32_t address = 0;  ///< that the burst begins at
    friend bool operator==(const Error&, const Error&) = default;
  };
  struct Inputs {
    bool stop = false;
    std::optional<Read> read;
    std::optional<Write> write;
    bool beat_ready = true;
    bool ar_ready = false, aw_ready = false, w_ready = false;
    std::optional<Answer> r;
    std::optional<unsigned> b;  ///< the response
  };
  struct Outputs {
    bool idle = true;
    bool read_ready = false, write_ready = false;
    std::optional<Beat> beat;
    std::optional<Read> ar;
    bool r_ready = false;
    std::optional<Burst> aw;
    std::optional<Word> w;
    std::optional<Error> error;
    friend bool operator==(const Outputs&, const Outputs&) = default;
  };
};

/// All reads have one id if they are answered InOrder, and then up to `Reads` are in flight;
/// `Writes` bursts of writes are.
template <unsigned Bytes, bool InOrder, unsigned Reads, unsigned Writes>
class AxiMemory {
 public:
  using Types = AxiMemoryTypes<Bytes>;
  using Inputs = typename Types::Inputs;
  using Outputs = typename Types::Outputs;

  Outputs outputs(const Inputs& in) const {
    Outputs out;
    out.idle = reads_.empty() && flight_.empty() && kept_.empty() && !open_;
    out.read_ready = reads_.size() < kBufferedTokens;
    out.write_ready = words_.size() < kBufferedTokens &&
                      (open_ || (bursts_.size() < kBufferedTokens && kept_.size() < Writes));
    if (in.r && !in.stop) out.beat = beat_of(*in.r);
    if (!reads_.empty() && has_room()) out.ar = reads_.front();
    out.r_ready = in.beat_ready || in.stop;
    if (!bursts_.empty()) out.aw = bursts_.front();
    if (!words_.empty()) out.w = words_.front();
    out.error = error_;
    return out;
  }

  void clock(const Inputs& in) {
    const Outputs out = outputs(in);
    error_.reset();
    if (in.b) take_response(*in.b);
    if (in.r && out.r_ready) take_answer(*in.r);
    if (out.ar && in.ar_ready) {
      flight_.push_back(reads_.front());
      reads_.pop_front();
    }
    if (out.aw && in.aw_ready) bursts_.pop_front();
    if (out.w && in.w_ready) words_.pop_front();
    if (in.read && !in.stop && out.read_ready) reads_.push_back(*in.read);
    if (out.write_ready) take_write(in);
  }

 private:
  bool has_room() const { return !InOrder || flight_.size() < Reads; }
  /// The read that an answer is of.
  auto read_of(const typename Types::Answer& answer) const {
    auto read = flight_.begin();
    while (!InOrder && read->id != answer.id) ++read;
    return read;
  }
  typename Types::Beat beat_of(const typename Types::Answer& answer) const {
    typename Types::Beat beat{.id = read_of(answer)->id, .data = answer.data, .last = answer.last};
    if ((answer.response & 2) != 0) beat.data = filling_of<typename Types::Data>(beat.id);
    return beat;
  }
  void take_answer(const typename Types::Answer& answer) {
    const auto read = read_of(answer);
    if ((answer.response & 2) != 0) {
      error_ = {.write = false, .response = answer.response, .address = read->address};
    }
    if (answer.last) flight_.erase(read);
  }
  void take_response(unsigned response) {
    if ((response & 2) != 0) {
      error_ = {.write = true, .response = response, .address = kept_.front()};
    }
    kept_.pop_front();
  }
  /// A burst that the core has begun is ended while it is in reset, by words that write nothing.
  void take_write(const Inputs& in) {
    const bool ends = in.stop && open_;
    if (!ends && (in.stop || !in.write)) return;
    const unsigned left = ends ? left_ - 1 : in.write->left;
    if (!open_) {
      bursts_.push_back({.address = in.write->address, .last = in.write->left});
      kept_.push_back(in.write->address);
    }
    typename Types::Word word{.data = {}, .mask = 0, .last = left == 0};
    if (!ends && in.write->mask != 0) {
      word.data = in.write->data;
      word.mask = in.write->mask;
    }
    words_.push_back(word);
    open_ = left != 0;
    left_ = left;
  }

  std::deque<typename Types::Read> reads_;
  std::deque<typename Types::Read> flight_;
  std::deque<typename Types::Burst> bursts_;
  std::deque<typename Types::Word> words_;
  std::deque<std::uint32_t> kept_;  ///< addresses of bursts that are not answered
  std::optional<typename Types::Error> error_;
  bool open_ = false;  ///< a burst of writes has begun and not ended
  unsigned left_ = 0;
};

}  // namespace dynrt
