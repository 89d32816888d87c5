// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// axi_memory and its native model in step, with random traffic, a bus that stalls each channel,
// answers late, in any order and with errors, and cores that are reset meanwhile: all outputs of
// each clock are equal.
#include "units/axi_memory.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <verilated.h>

#include <algorithm>
#include <memory>
#include <random>
#include <type_traits>
#include <vector>

#include "Vaxi_memory_any_order.h"
#include "Vaxi_memory_in_order.h"

namespace dynrt::host::bus {
namespace {

constexpr unsigned kBytes = 4;
using Types = AxiMemoryTypes<kBytes>;

/// The Verilog with the functions of its native model.
template <class V, bool InOrder>
class Rtl {
 public:
  explicit Rtl(int seed) {
    context_.randReset(2);
    context_.randSeed(seed);
    v_ = std::make_unique<V>(&context_);
    v_->rst_ni = 0;
    for (int i = 0; i < 4; ++i) clock({});
    v_->rst_ni = 1;
  }
  ~Rtl() { v_->final(); }
  Rtl(const Rtl&) = delete;
  Rtl& operator=(const Rtl&) = delete;

  Types::Outputs outputs(const Types::Inputs& in) {
    drive(in);
    Types::Outputs out;
    out.idle = v_->idle_o != 0;
    out.read_ready = v_->read_ready_o != 0;
    out.write_ready = v_->write_ready_o != 0;
    if (v_->beat_valid_o != 0) {
      out.beat = {.id = v_->beat_id_o, .data = {v_->beat_data_o}, .last = v_->beat_last_o != 0};
    }
    if (v_->m_axi_arvalid != 0) {
      EXPECT_EQ(v_->m_axi_araddr >> 25, kBase >> 25);
      out.ar = {.id = InOrder ? 0u : v_->m_axi_arid,
                .address = v_->m_axi_araddr & 0x1ffffff,
                .last = v_->m_axi_arlen};
    }
    out.r_ready = v_->m_axi_rready != 0;
    if (v_->m_axi_awvalid != 0) {
      EXPECT_EQ(v_->m_axi_awaddr >> 25, kBase >> 25);
      out.aw = {.address = v_->m_axi_awaddr & 0x1ffffff, .last = v_->m_axi_awlen};
    }
    if (v_->m_axi_wvalid != 0) {
      const unsigned strobe = v_->m_axi_wstrb;
      EXPECT_EQ((strobe ^ strobe >> 1) & 5u, 0u);
      const unsigned mask = (strobe & 1u) | (strobe >> 2 & 1u) << 1;
      out.w = {
          .data = {mask == 0 ? 0 : v_->m_axi_wdata}, .mask = mask, .last = v_->m_axi_wlast != 0};
    }
    if (v_->error_o != 0) {
      out.error = {.write = v_->error_write_o != 0,
                   .response = v_->error_response_o,
                   .address = v_->error_address_o};
    }
    return out;
  }
  void clock(const Types::Inputs& in) {
    drive(in);
    v_->clk_i = 1;
    v_->eval();
  }

 private:
  static constexpr std::uint32_t kBase = 0xc200'0000;
  void drive(const Types::Inputs& in) {
    v_->base_i = kBase;
    v_->stop_i = in.stop;
    v_->read_valid_i = in.read.has_value();
    const Types::Read read = in.read.value_or(Types::Read{});
    v_->read_id_i = static_cast<unsigned short>(read.id);
    v_->read_address_i = read.address;
    v_->read_last_i = static_cast<unsigned char>(read.last);
    v_->write_valid_i = in.write.has_value();
    const Types::Write write = in.write.value_or(Types::Write{});
    v_->write_address_i = write.address;
    v_->write_data_i = write.data[0];
    v_->write_mask_i = static_cast<unsigned char>(write.mask);
    v_->write_left_i = static_cast<unsigned char>(write.left);
    v_->beat_ready_i = in.beat_ready;
    v_->m_axi_arready = in.ar_ready;
    v_->m_axi_awready = in.aw_ready;
    v_->m_axi_wready = in.w_ready;
    const Types::Answer answer = in.r.value_or(Types::Answer{});
    v_->m_axi_rvalid = in.r.has_value();
    v_->m_axi_rid =
        static_cast<std::remove_reference_t<decltype(v_->m_axi_rid)>>(InOrder ? 0 : answer.id);
    v_->m_axi_rdata = answer.data[0];
    v_->m_axi_rresp = static_cast<unsigned char>(answer.response);
    v_->m_axi_rlast = answer.last;
    v_->m_axi_bvalid = in.b.has_value();
    v_->m_axi_bresp = static_cast<unsigned char>(in.b.value_or(0));
    v_->clk_i = 0;
    v_->eval();
  }

  VerilatedContext context_;
  std::unique_ptr<V> v_;
};

/// How often in a hundred clocks each side is willing.
struct Tempers {
  unsigned asks, takes, ready, answers, errors;
};

/// The core and the bus's memory, with random numbers of one seed.
template <bool InOrder>
class Sides {
 public:
  Sides(int seed, const Tempers& tempers)
      : random_(static_cast<unsigned>(seed)), tempers_(tempers) {}

  Types::Inputs in;
  unsigned beats = 0, bursts = 0, errors = 0;

  void offer(bool idle) {
    if (in.stop ? idle : random_() % 2000 == 0) {
      in.stop = !in.stop;
      in.read.reset();
      in.write.reset();
      left_ = 0;
    }
    if (!in.stop && !in.read && happens(tempers_.asks)) offer_read();
    if (!in.stop && !in.write && happens(tempers_.asks)) offer_write();
    in.beat_ready = happens(tempers_.takes);
    in.ar_ready = happens(tempers_.ready);
    in.aw_ready = happens(tempers_.ready);
    in.w_ready = happens(tempers_.ready);
    if (!in.r && !asked_.empty() && happens(tempers_.answers)) answer();
    in.b.reset();
    if (std::min(addresses_, lasts_) > answered_ && happens(tempers_.answers)) {
      in.b = response();
      ++answered_;
    }
  }
  void seen(const Types::Outputs& out) {
    if (out.ar && in.ar_ready) asked_.push_back({*out.ar, 0});
    if (out.aw && in.aw_ready) ++addresses_;
    if (out.w && in.w_ready && out.w->last) ++lasts_;
    if (in.r && out.r_ready) {
      if (in.r->last) std::erase(ids_, id_);
      in.r.reset();
      ++beats;
    }
    if (in.read && out.read_ready) in.read.reset();
    if (in.write && out.write_ready) {
      left_ = in.write->left;
      in.write.reset();
      bursts += left_ == 0 ? 1 : 0;
    }
    errors += out.error ? 1 : 0;
  }

 private:
  bool happens(unsigned percent) { return random_() % 100 < percent; }
  unsigned response() { return happens(tempers_.errors) ? 2 + happens(50) : 0; }
  void offer_read() {
    const auto id = static_cast<std::uint32_t>(random_() % 1024);
    if (std::ranges::find(ids_, id) != ids_.end()) return;
    ids_.push_back(id);
    in.read = {.id = id,
               .address = static_cast<std::uint32_t>(random_() % (1u << 19)) * 32,
               .last = InOrder ? static_cast<unsigned>(random_() % 8) : 0};
  }
  void offer_write() {
    in.write = {.address = static_cast<std::uint32_t>(random_() % (1u << 23)) * kBytes,
                .data = {static_cast<std::uint32_t>(random_())},
                .mask = static_cast<std::uint32_t>(random_() % 4),
                .left = left_ > 0 ? left_ - 1 : static_cast<unsigned>(random_() % 4)};
  }
  void answer() {
    const std::size_t which = InOrder ? 0 : random_() % asked_.size();
    auto& [read, beat] = asked_[which];
    in.r = {.id = read.id,
            .data = {static_cast<std::uint32_t>(random_())},
            .response = response(),
            .last = beat == read.last};
    id_ = read.id;
    if (beat++ == read.last) asked_.erase(asked_.begin() + static_cast<std::ptrdiff_t>(which));
  }

  std::mt19937 random_;
  Tempers tempers_;
  struct Asked {
    Types::Read read;
    unsigned beat;
  };
  std::vector<Asked> asked_;
  std::vector<std::uint32_t> ids_;  ///< of reads that are not answered
  std::uint32_t id_ = 0;            ///< of the answer
  unsigned left_ = 0;
  unsigned addresses_ = 0, lasts_ = 0, answered_ = 0;
};

template <class V, bool InOrder, unsigned Reads, unsigned Writes>
void run_in_step(int seed, const Tempers& tempers) {
  Rtl<V, InOrder> rtl(seed);
  AxiMemory<kBytes, InOrder, Reads, Writes> model;
  Sides<InOrder> sides(seed, tempers);
  for (unsigned i = 0; i < 20'000; ++i) {
    sides.offer(model.outputs(sides.in).idle);
    const Types::Outputs there = rtl.outputs(sides.in);
    const Types::Outputs here = model.outputs(sides.in);
    Types::Outputs shown = here;
    if (InOrder && shown.ar) shown.ar->id = 0;  // the bus does not see it
    ASSERT_TRUE(there == shown) << fmt::format("clock {} of seed {}", i, seed);
    rtl.clock(sides.in);
    model.clock(sides.in);
    sides.seen(here);
  }
  EXPECT_GT(sides.beats, 200u);
  EXPECT_GT(sides.bursts, 200u);
  EXPECT_EQ(sides.errors > 0, tempers.errors > 0);
}

constexpr Tempers kTempers[] = {{100, 100, 100, 100, 0},
                                {50, 50, 50, 50, 5},
                                {90, 20, 90, 90, 0},
                                {90, 90, 20, 20, 50},
                                {10, 90, 90, 90, 10}};

TEST(AxiMemory, IsItsTwinInEachClock) {
  int seed = 0;
  for (const Tempers& tempers : kTempers) {
    run_in_step<Vaxi_memory_in_order, true, 5, 3>(++seed, tempers);
    run_in_step<Vaxi_memory_any_order, false, 64, 16>(++seed, tempers);
  }
}

}  // namespace
}  // namespace dynrt::host::bus
