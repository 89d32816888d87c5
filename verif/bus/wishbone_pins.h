// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The other ends of the buses of dynrt_wishbone: a memory that stalls and answers late, in order;
// and a host that reads and writes registers. V is the Verilated class. In every clock they see the
// pins before its edge (sample) and set them for the next (drive).
#pragma once

#include <array>
#include <cstring>
#include <deque>
#include <stdexcept>
#include <utility>

#include "bus/bus_memory.h"

namespace dynrt::host::bus {

template <class V>
class WishboneMemory : public BusMemory {
 public:
  using BusMemory::BusMemory;

  void sample(const V& top) {
    if (!top.m_wb_cyc_o && !accesses_.empty()) {
      throw std::logic_error("CYC fell before the last answer");
    }
    if (top.m_wb_ack_i || top.m_wb_err_i) {
      const Access& access = accesses_.front();
      if (access.response != 0) seen({access.write, access.response, access.byte});
      accesses_.pop_front();
    }
    if (top.m_wb_cyc_o && top.m_wb_stb_o && !top.m_wb_stall_i) take(top);
    ++now_;
  }
  void drive(V& top) {
    set(top.m_wb_stall_i, !happens(temper_.ready));
    const bool answers =
        !accesses_.empty() && accesses_.front().from <= now_ && happens(temper_.answers);
    set(top.m_wb_ack_i, answers && accesses_.front().response == 0);
    set(top.m_wb_err_i, answers && accesses_.front().response != 0);
    if (!answers || accesses_.front().write) return;
    std::array<std::uint8_t, kBeatBytes> data;
    load(accesses_.front().byte, top.m_wb_err_i, data);
    std::memcpy(&top.m_wb_dat_i, data.data(), kBeatBytes);
  }

 private:
  static constexpr unsigned kBeatBytes = sizeof(std::declval<V&>().m_wb_dat_i);
  struct Access {
    bool write;
    unsigned byte;
    unsigned response;
    std::uint64_t from;
  };

  void take(const V& top) {
    const unsigned byte = byte_of(top.m_wb_adr_o);
    const bool write = top.m_wb_we_o;
    // Wishbone has but one kind of error.
    const unsigned fault = response(write, byte) == 0 ? 0 : 2;
    if (write && fault == 0) {
      std::array<std::uint8_t, kBeatBytes> data;
      std::memcpy(data.data(), &top.m_wb_dat_o, kBeatBytes);
      store(byte, data, top.m_wb_sel_o);
    }
    accesses_.push_back({write, byte, fault, now_ + some_clocks()});
    ++(write ? writes_ : reads_);
  }

  std::deque<Access> accesses_;
};

/// One access at a time.
template <class V>
class WishboneHost {
 public:
  explicit WishboneHost(int seed) : random_(static_cast<unsigned>(seed)) {}

  void begin_write(std::uint32_t address, std::uint32_t data, unsigned strobe = 15) {
    begin(true, address, data, strobe);
  }
  void begin_read(std::uint32_t address) { begin(false, address, 0, 15); }
  bool idle() const { return !answer_waits_; }
  RegisterAnswer written() const { return answer_; }
  RegisterAnswer read() const { return answer_; }

  void sample(const V& top) {
    if (top.s_wb_stb_i && !top.s_wb_stall_o) waits_ = false;
    if (top.s_wb_ack_o || top.s_wb_err_o) {
      answer_ = {top.s_wb_err_o != 0, top.s_wb_dat_o};
      answer_waits_ = false;
    }
    ++now_;
  }
  void drive(V& top) {
    set(top.s_wb_cyc_i, answer_waits_ && from_ <= now_);
    set(top.s_wb_stb_i, waits_ && from_ <= now_);
    set(top.s_wb_we_i, write_);
    set(top.s_wb_adr_i, address_);
    set(top.s_wb_dat_i, data_);
    set(top.s_wb_sel_i, strobe_);
  }

 private:
  void begin(bool write, std::uint32_t address, std::uint32_t data, unsigned strobe) {
    write_ = write;
    address_ = address;
    data_ = data;
    strobe_ = strobe;
    from_ = now_ + random_() % 4;
    waits_ = answer_waits_ = true;
  }

  bool write_ = false, waits_ = false, answer_waits_ = false;
  std::uint32_t address_ = 0, data_ = 0;
  unsigned strobe_ = 15;
  std::uint64_t from_ = 0, now_ = 0;
  RegisterAnswer answer_;
  std::mt19937 random_;
};

}  // namespace dynrt::host::bus
