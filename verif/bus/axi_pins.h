// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The other ends of the buses of dynrt_axi: a memory that stalls every channel, and answers reads
// of different ids in any order, their beats mixed; and a host that reads and writes registers. V
// is the Verilated class. In every clock they see the pins before its edge (sample) and set them
// for the next (drive).
#pragma once

#include <array>
#include <cstring>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "bus/bus_memory.h"

namespace dynrt::host::bus {

template <class V>
class AxiMemory : public BusMemory {
 public:
  using BusMemory::BusMemory;

  void sample(const V& top) {
    if (top.m_axi_rvalid && top.m_axi_rready) beat_taken();
    if (top.m_axi_bvalid) answer_taken();
    if (top.m_axi_arvalid && top.m_axi_arready) {
      const unsigned byte = byte_of(top.m_axi_araddr);
      reads_in_flight_.push_back({top.m_axi_arid, byte, 0, top.m_axi_arlen, now_ + some_clocks()});
      ++reads_;
    }
    if (top.m_axi_awvalid && top.m_axi_awready) {
      addresses_.push_back({byte_of(top.m_axi_awaddr), top.m_axi_awlen + 1u});
    }
    if (top.m_axi_wvalid && top.m_axi_wready) {
      WriteBeat beat{{}, static_cast<std::uint64_t>(top.m_axi_wstrb)};
      std::memcpy(beat.data.data(), &top.m_axi_wdata, kBeatBytes);
      data_.push_back(beat);
    }
    if (!addresses_.empty() && data_.size() >= addresses_.front().beats) write();
    ++now_;
  }

  void drive(V& top) {
    set(top.m_axi_arready, happens(temper_.ready));
    set(top.m_axi_awready, happens(temper_.ready));
    set(top.m_axi_wready, happens(temper_.ready));
    if (!offered_ && happens(temper_.answers)) offered_ = choose();
    set(top.m_axi_rvalid, offered_.has_value());
    if (offered_) {
      set(top.m_axi_rid, reads_in_flight_[*offered_].id);
      set(top.m_axi_rresp, offer_.response);
      set(top.m_axi_rlast, reads_in_flight_[*offered_].beat == reads_in_flight_[*offered_].last);
      std::memcpy(&top.m_axi_rdata, offer_.data.data(), kBeatBytes);
    }
    // An answer that is offered stays: the core is always ready for it.
    top.m_axi_bvalid =
        !answers_.empty() && answers_.front().from <= now_ && happens(temper_.answers);
    if (top.m_axi_bvalid) set(top.m_axi_bresp, answers_.front().response);
    set(top.m_axi_bid, 0);
  }

 private:
  using Id = std::remove_cvref_t<decltype(std::declval<V&>().m_axi_rid)>;
  static constexpr unsigned kBeatBytes = sizeof(std::declval<V&>().m_axi_rdata);
  using Data = std::array<std::uint8_t, kBeatBytes>;
  struct Read {
    Id id;
    unsigned byte;
    unsigned beat, last;
    std::uint64_t from;
  };
  struct Address {
    unsigned byte;
    unsigned beats;
  };
  struct WriteBeat {
    Data data;
    std::uint64_t strobe;
  };
  struct Answer {
    unsigned byte;
    unsigned response;
    std::uint64_t from;
  };
  struct Offer {
    unsigned response;
    Data data;
  };

  /// A read whose answer is there, any that no older one of its id is before.
  std::optional<std::size_t> choose() {
    std::vector<bool> met(std::size_t{1} << (8 * sizeof(Id)));
    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < reads_in_flight_.size(); ++i) {
      const Read& read = reads_in_flight_[i];
      if (!met[read.id] && read.from <= now_) there.push_back(i);
      met[read.id] = true;
    }
    if (there.empty()) return std::nullopt;
    const std::size_t chosen = there[(some_byte() << 8 | some_byte()) % there.size()];
    const Read& read = reads_in_flight_[chosen];
    offer_.response = response(false, read.byte);
    load(read.byte + read.beat * kBeatBytes, offer_.response != 0, offer_.data);
    return chosen;
  }
  void beat_taken() {
    Read& read = reads_in_flight_[*offered_];
    if (offer_.response != 0) seen({false, offer_.response, read.byte});
    if (read.beat++ == read.last) {
      reads_in_flight_.erase(reads_in_flight_.begin() + static_cast<std::ptrdiff_t>(*offered_));
    }
    offered_.reset();
  }
  void answer_taken() {
    const Answer& answer = answers_.front();
    if (answer.response != 0) seen({true, answer.response, answer.byte});
    answers_.pop_front();
  }
  void write() {
    const Address address = addresses_.front();
    const unsigned fault = response(true, address.byte);
    for (unsigned beat = 0; beat < address.beats; ++beat) {
      if (fault == 0) {
        store(address.byte + beat * kBeatBytes, data_.front().data, data_.front().strobe);
      }
      data_.pop_front();
    }
    addresses_.pop_front();
    answers_.push_back({address.byte, fault, now_ + some_clocks()});
    ++writes_;
  }

  std::vector<Read> reads_in_flight_;
  std::optional<std::size_t> offered_;
  Offer offer_{};
  std::deque<Address> addresses_;
  std::deque<WriteBeat> data_;
  std::deque<Answer> answers_;
};

/// One read and one write at a time, the parts of the write in any order.
template <class V>
class AxiLiteHost {
 public:
  explicit AxiLiteHost(int seed) : random_(static_cast<unsigned>(seed)) {}

  void begin_write(std::uint32_t address, std::uint32_t data, unsigned strobe = 15) {
    write_ = {.address = address, .data = data, .strobe = strobe};
    write_.from = now_ + static_cast<unsigned>(random_() % 4);
    write_.data_from = now_ + static_cast<unsigned>(random_() % 4);
    write_.waits = write_.data_waits = write_.answer_waits = true;
  }
  void begin_read(std::uint32_t address) {
    read_ = {.address = address};
    read_.from = now_ + static_cast<unsigned>(random_() % 4);
    read_.waits = read_.answer_waits = true;
  }
  bool idle() const { return !write_.answer_waits && !read_.answer_waits; }
  RegisterAnswer written() const { return write_.answer; }
  RegisterAnswer read() const { return read_.answer; }

  void sample(const V& top) {
    if (top.s_axil_awvalid && top.s_axil_awready) write_.waits = false;
    if (top.s_axil_wvalid && top.s_axil_wready) write_.data_waits = false;
    if (top.s_axil_arvalid && top.s_axil_arready) read_.waits = false;
    if (top.s_axil_bvalid && top.s_axil_bready) {
      write_.answer = {top.s_axil_bresp != 0, 0};
      write_.answer_waits = false;
    }
    if (top.s_axil_rvalid && top.s_axil_rready) {
      read_.answer = {top.s_axil_rresp != 0, top.s_axil_rdata};
      read_.answer_waits = false;
    }
    ++now_;
  }
  void drive(V& top) {
    set(top.s_axil_awvalid, write_.waits && write_.from <= now_);
    set(top.s_axil_awaddr, write_.address);
    set(top.s_axil_wvalid, write_.data_waits && write_.data_from <= now_);
    set(top.s_axil_wdata, write_.data);
    set(top.s_axil_wstrb, write_.strobe);
    set(top.s_axil_arvalid, read_.waits && read_.from <= now_);
    set(top.s_axil_araddr, read_.address);
    set(top.s_axil_bready, random_() % 2);
    set(top.s_axil_rready, random_() % 2);
  }

 private:
  struct Access {
    std::uint32_t address = 0, data = 0;
    unsigned strobe = 0;
    std::uint64_t from = 0, data_from = 0;
    bool waits = false, data_waits = false, answer_waits = false;
    RegisterAnswer answer = {};
  };
  Access write_, read_;
  std::uint64_t now_ = 0;
  std::mt19937 random_;
};

}  // namespace dynrt::host::bus
