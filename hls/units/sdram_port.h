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
#include "units/sdram_controller.h"

namespace dynrt {

/// A beat has PortBytes bytes, 8 to 32; reads and writes lie within 32 bytes, on whole beats.
template <unsigned PortBytes>
struct SdramPortTypes {
  static_assert(PortBytes == 8 || PortBytes == 16 || PortBytes == 32);
  static constexpr unsigned kHalves = PortBytes / 2;
  using Data = std::array<std::uint16_t, kHalves>;
  struct Read {
    std::uint32_t id = 0;
    std::uint32_t address = 0;
    unsigned last = 0;  ///< beats less one
  };
  struct Write {
    std::uint32_t address = 0;
    Data data{};
    std::uint32_t mask = 0;  ///< a bit for each half
  };
  struct Beat {
    std::uint32_t id = 0;
    Data data{};
    bool last = false;
    friend bool operator==(const Beat&, const Beat&) = default;
  };
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
  static constexpr unsigned kWrites = 8;  ///< beats to be written
  static constexpr unsigned kBatch = 4;   ///< requests of a kind while the other kind waits

  SdramPort(unsigned stages, unsigned pause_turns) : steps_(stages) {
    controller_.request.bind(requests_);
    controller_.pins.bind(tokens_);
    controller_.pause.bind(std::make_shared<uint<16>>(uint<16>::from(pause_turns)));
  }

  Outputs outputs(const Inputs& /*in*/ = {}) const {
    Outputs out;
    const bool room = waiting_ < kSdramQueue;
    out.read_ready = !writes_turn_ && room && free_beats_ >= 32 / PortBytes;
    out.write_ready = writes_turn_ && room && written_.size() < kWrites;
    if (beats_valid_) out.beat = beats_.front();
    out.pins = pins_;
    return out;
  }

  void clock(const Inputs& in) {
    const Outputs out = outputs();
    const bool reads = in.read && out.read_ready;
    const bool writes = in.write && out.write_ready;
    const std::optional<SdramPins> token = steps_.front();
    take_beat(in, out);
    read_words(token);
    dq_ = in.dq;
    drive(token);

    const SdramRequest request = request_;
    request_ = {};
    if (reads) take_read(*in.read);
    if (writes) take_write(*in.write);
    waiting_ += request_.valid ? 1 : 0;
    waiting_ -= token && token->taken ? 1 : 0;
    choose(in, reads || writes);

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
  /// Clocks from a token to the word that it reads, in dq_: the pins' registers on either side, and
  /// the CAS latency.
  static constexpr unsigned kReadClocks = S::kCasLatency + 2;
  static constexpr unsigned kHalves = Types::kHalves;

  void take_read(const typename Types::Read& read) {
    free_beats_ -= read.last + 1;
    expected_.push_back({read.id, read.last});
    request_ = request_at(read.address, (read.last + 1) * PortBytes / 4, false);
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
    written_.push_back(write);
    request_ = request_at(write.address + 4 * first, last - first + 1, true);
  }
  static SdramRequest request_at(std::uint32_t address, unsigned pairs, bool writes) {
    return {.valid = true,
            .burst = {.place = {.pair = uint<8>::from(address >> 2),
                                .bank = uint<2>::from(address >> 10),
                                .row = uint<13>::from(address >> 12)},
                      .last = uint<3>::from(pairs - 1),
                      .write = writes}};
  }
  /// The kind goes on while only it waits, and for kBatch requests while both do.
  void choose(const Inputs& in, bool took) {
    const bool this_waits = writes_turn_ ? in.write.has_value() : in.read.has_value();
    const bool other_waits = writes_turn_ ? in.read.has_value() : in.write.has_value();
    const bool changes = other_waits && (!this_waits || (took && batch_ == kBatch - 1));
    batch_ = changes || !other_waits ? 0 : batch_ + (took ? 1 : 0);
    if (changes) writes_turn_ = !writes_turn_;
  }

  void drive(const std::optional<SdramPins>& token) {
    if (!token) return;
    const auto word = static_cast<unsigned>(token->word.to_u64());
    pins_ = {token->command,
             static_cast<unsigned>(token->bank.to_u64()),
             static_cast<unsigned>(token->address.to_u64()),
             token->ready ? 0u : 3u,
             token->writes,
             0};
    if (!token->writes) return;
    pins_.dq = written_.front().data[word % kHalves];
    if ((written_.front().mask >> word % kHalves & 1) == 0) pins_.dqm = 3;
    if (token->last) written_.pop_front();
  }
  void read_words(const std::optional<SdramPins>& token) {
    coming_.push_back(token && token->reads ? std::optional(token->word) : std::nullopt);
    if (coming_.size() <= kReadClocks) return;
    const auto word = coming_.front();
    coming_.pop_front();
    if (!word) return;
    const auto at = static_cast<unsigned>(word->to_u64()) % kHalves;
    beat_[at] = dq_;
    if (at + 1 < kHalves) return;
    const bool last = expected_.front().last == beat_number_;
    arrived_ = Beat{expected_.front().id, beat_, last};
    beat_number_ = last ? 0 : beat_number_ + 1;
    if (last) expected_.pop_front();
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

  std::deque<Write> written_;
  typename Types::Pins pins_;

  std::deque<std::optional<uint<4>>> coming_;  ///< words that are read
  std::uint16_t dq_ = 0;
  typename Types::Data beat_{};
  std::optional<Beat> arrived_;
  std::deque<Expected> expected_;
  unsigned beat_number_ = 0;
  unsigned free_beats_ = kBeats;
  std::deque<Beat> beats_;
  bool beats_valid_ = false;
};

}  // namespace dynrt
