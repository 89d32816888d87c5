// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The native twin of rtl/sdram/sdram_port.v, clock by clock: the memory port on one side, the pins
// of an SDRAM on the other, the unit sdram_controller between them. outputs() are those of a clock,
// clock() its rising edge.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "hls/ports.h"
#include "units/port_items.h"
#include "units/sdram_controller.h"

namespace dynrt {

/// A beat has PortBytes bytes, 8 to 32; reads and writes lie within 32 bytes, on whole beats.
template <unsigned PortBytes>
struct SdramPortTypes {
  static_assert(PortBytes == 8 || PortBytes == 16 || PortBytes == 32);
  static constexpr unsigned kHalves = PortBytes / 2;
  using Data = std::array<std::uint16_t, kHalves>;
  using Read = typename PortItems<Data>::Read;
  using Write = typename PortItems<Data>::Write;
  using Beat = typename PortItems<Data>::Beat;
  struct Inputs {
    std::optional<Read> read;
    std::optional<Write> write;
    bool beat_ready = true;
    std::uint16_t dq = 0;
  };
  /// The pins, as registers hold them.
  struct Pins {
    SdramCommand command = SdramCommand::kNone;
    unsigned bank = 0;
    unsigned address = 0;
    unsigned dqm = 3;
    bool drives = false;
    std::uint16_t dq = 0;
    friend bool operator==(const Pins&, const Pins&) = default;
  };
  struct Outputs {
    bool read_ready = false;
    bool write_ready = false;
    std::optional<Beat> beat;
    Pins pins;
  };
};

/// `stages` are the clocks from the controller's token in to its token out (its schedule).
template <class S, unsigned PortBytes>
class SdramPort {
 public:
  using Types = SdramPortTypes<PortBytes>;
  using Inputs = typename Types::Inputs;
  using Outputs = typename Types::Outputs;
  using Beat = typename Types::Beat;
  static constexpr unsigned kBeats = 32;  ///< places for beats that are read
  static constexpr unsigned kReads = 32;  ///< that may be on their way
  static constexpr unsigned kWrites = 16;
  static constexpr unsigned kPatience = 256;  ///< clocks that a write waits for reads, at most
  static constexpr unsigned kBatch = 32;      ///< writes while a read waits, at most

  SdramPort(unsigned stages, unsigned pause_turns) : steps_(stages) {
    controller_.request.bind(requests_);
    controller_.pins.bind(tokens_);
    controller_.pause.bind(std::make_shared<uint<16>>(uint<16>::from(pause_turns)));
  }

  Outputs outputs(const Inputs& /*in*/ = {}) const {
    Outputs out;
    const bool room = waiting_ < kSdramQueue;
    out.read_ready = !writes_turn_ && room && free_beats_ >= 32 / PortBytes && read_free_;
    out.write_ready = writes_turn_ && room && write_free_;
    if (beats_valid_) out.beat = beats_.front();
    out.pins = pins_;
    return out;
  }

  void clock(const Inputs& in) {
    const Outputs out = outputs();
    const bool reads = in.read && out.read_ready;
    const bool writes = in.write && out.write_ready;
    const bool read_free = !reads_[(read_slot_ + (reads ? 1 : 0)) % kReads];
    const bool write_free =
        !writes_[(write_slot_ + (writes && in.write->mask != 0 ? 1 : 0)) % kWrites];
    const std::optional<SdramPins> token = steps_.front();
    take_beat(in, out);
    read_words(token);
    dq_ = in.dq;
    pins_ = next_pins_;
    next_pins_ = pins_of(token);

    const SdramRequest request = request_;
    request_ = {};
    if (reads) take_read(*in.read);
    if (writes) take_write(*in.write);
    waiting_ += request_.valid ? 1 : 0;
    if (token) waiting_ -= static_cast<unsigned>(token->taken.to_u64());
    choose(in, reads || writes);
    read_free_ = read_free;
    write_free_ = write_free;

    requests_->push(request);
    controller_.step();
    steps_.pop_front();
    steps_.push_back(tokens_->pop());
  }

 private:
  struct Expected {
    std::uint32_t id;
    unsigned last;
  };
  using Write = typename Types::Write;
  /// Clocks from a token to the word that it reads, in dq_: two registers before the pins, one
  /// behind them, and the CAS latency.
  static constexpr unsigned kReadClocks = S::kCasLatency + 3;
  static constexpr unsigned kHalves = Types::kHalves;

  void take_read(const typename Types::Read& read) {
    free_beats_ -= read.last + 1;
    reads_[read_slot_] = {read.id, read.last};
    request_ = request_at(read.address, (read.last + 1) * PortBytes / 4, false, read_slot_);
    read_slot_ = (read_slot_ + 1) % kReads;
  }
  void take_write(const Write& write) {
    unsigned first = kHalves;
    unsigned last = 0;
    for (unsigned i = 0; i < kHalves; ++i) {
      if ((write.mask >> i & 1) == 0) continue;
      first = std::min(first, i / 2);
      last = i / 2;
    }
    if (write.mask == 0) return;
    writes_[write_slot_] = write;
    request_ = request_at(write.address + 4 * first, last - first + 1, true, write_slot_);
    write_slot_ = (write_slot_ + 1) % kWrites;
  }
  static SdramRequest request_at(std::uint32_t address, unsigned pairs, bool writes,
                                 unsigned slot) {
    return {.valid = true,
            .burst = {.place = {.pair = uint<8>::from(address >> 2),
                                .bank = uint<2>::from(address >> 10),
                                .row = uint<13>::from(address >> 12)},
                      .last = uint<3>::from(pairs - 1),
                      .write = writes,
                      .tag = uint<5>::from(slot)}};
  }
  /// Each way costs clocks to turn to, so writes wait for a while and then go together.
  void choose(const Inputs& in, bool took) {
    const bool late = waited_ == kPatience - 1;
    const bool full = took && batch_ == kBatch - 1;
    const bool changes =
        writes_turn_ ? in.read && (!in.write || full) : in.write && (!in.read || late);
    batch_ = changes || !writes_turn_ ? 0 : (batch_ + (took ? 1 : 0)) % kBatch;
    waited_ = writes_turn_ || !in.write ? 0 : late ? waited_ : waited_ + 1;
    if (changes) writes_turn_ = !writes_turn_;
  }

  typename Types::Pins pins_of(const std::optional<SdramPins>& token) {
    if (!token) return {};
    typename Types::Pins pins{.command = token->command,
                              .bank = static_cast<unsigned>(token->bank.to_u64()),
                              .address = static_cast<unsigned>(token->address.to_u64()),
                              .dqm = token->ready ? 0u : 3u,
                              .drives = token->writes,
                              .dq = 0};
    if (!token->writes) return pins;
    std::optional<Write>& write = writes_.at(token->tag.to_u64());
    const auto half = static_cast<unsigned>(token->word.to_u64()) % kHalves;
    pins.dq = write->data[half];
    if ((write->mask >> half & 1) == 0) pins.dqm = 3;
    if (token->last) write.reset();
    return pins;
  }
  void read_words(const std::optional<SdramPins>& token) {
    coming_.push_back(token && token->reads ? token : std::nullopt);
    if (coming_.size() <= kReadClocks) return;
    const auto word = coming_.front();
    coming_.pop_front();
    if (!word) return;
    const auto half = static_cast<unsigned>(word->word.to_u64()) % kHalves;
    beat_[half] = dq_;
    if (half + 1 < kHalves) return;
    std::optional<Expected>& read = reads_.at(word->tag.to_u64());
    const bool last = read->last == beat_number_;
    arrived_ = Beat{read->id, beat_, last};
    beat_number_ = last ? 0 : beat_number_ + 1;
    if (last) read.reset();
  }
  void take_beat(const Inputs& in, const Outputs& out) {
    if (out.beat && in.beat_ready) {
      beats_.pop_front();
      ++free_beats_;
    }
    if (arrived_) beats_.push_back(*arrived_);
    arrived_.reset();
    beats_valid_ = !beats_.empty();
  }

  SdramController<S> controller_;
  std::shared_ptr<hls::Fifo<SdramRequest>> requests_ = std::make_shared<hls::Fifo<SdramRequest>>();
  std::shared_ptr<hls::Fifo<SdramPins>> tokens_ = std::make_shared<hls::Fifo<SdramPins>>();
  std::deque<std::optional<SdramPins>> steps_;  ///< the controller's pipeline

  SdramRequest request_;
  unsigned waiting_ = 0;  ///< in the controller's queue, or on the way to it
  bool writes_turn_ = false;
  unsigned batch_ = 0;
  unsigned waited_ = 0;

  std::array<std::optional<Expected>, kReads> reads_;
  std::array<std::optional<Write>, kWrites> writes_;
  unsigned read_slot_ = 0;
  unsigned write_slot_ = 0;
  bool read_free_ = true;  ///< the slot
  bool write_free_ = true;
  typename Types::Pins next_pins_;
  typename Types::Pins pins_;

  std::deque<std::optional<SdramPins>> coming_;  ///< words that are read
  std::uint16_t dq_ = 0;
  typename Types::Data beat_{};
  std::optional<Beat> arrived_;
  unsigned beat_number_ = 0;
  unsigned free_beats_ = kBeats;
  std::deque<Beat> beats_;
  bool beats_valid_ = false;
};

}  // namespace dynrt
