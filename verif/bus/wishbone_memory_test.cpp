// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// wishbone_memory and its native model in step, with random traffic, a bus that stalls, answers
// late and with errors, and cores that are reset meanwhile: all outputs of each clock are equal.
#include "units/wishbone_memory.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <verilated.h>

#include <memory>
#include <random>

#include "Vwishbone_memory_3.h"
#include "Vwishbone_memory_64.h"

namespace dynrt::host::bus {
namespace {

constexpr unsigned kBytes = 4;
using Types = WishboneMemoryTypes<kBytes>;

/// The Verilog with the functions of its native model.
template <class V>
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
    out.cycle = v_->m_wb_cyc_o != 0;
    if (v_->m_wb_stb_o != 0) {
      Types::Access access{.write = v_->m_wb_we_o != 0,
                           .address = v_->m_wb_adr_o & 0x1ffffff,
                           .mask = (v_->m_wb_sel_o & 1u) | (v_->m_wb_sel_o >> 2 & 1u) << 1};
      EXPECT_EQ(v_->m_wb_adr_o >> 25, kBase >> 25);
      EXPECT_EQ((v_->m_wb_sel_o ^ v_->m_wb_sel_o >> 1) & 5u, 0u);
      if (access.write) access.data = {v_->m_wb_dat_o};
      out.access = access;
    }
    if (v_->error_o != 0) {
      out.error = {.write = v_->error_write_o != 0, .address = v_->error_address_o};
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
    v_->beat_ready_i = in.beat_ready;
    v_->m_wb_stall_i = in.stall;
    v_->m_wb_ack_i = in.ack;
    v_->m_wb_err_i = in.err;
    v_->m_wb_dat_i = in.data[0];
    v_->clk_i = 0;
    v_->eval();
  }

  VerilatedContext context_;
  std::unique_ptr<V> v_;
};

/// How often in a hundred clocks each side is willing.
struct Tempers {
  unsigned asks, takes, stalls, answers, errors;
};

template <class V, unsigned Flight, unsigned Turn>
void run_in_step(int seed, const Tempers& tempers) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto happens = [&](unsigned percent) { return random() % 100 < percent; };
  Rtl<V> rtl(seed);
  WishboneMemory<kBytes, Flight, Turn> model;
  Types::Inputs in;
  unsigned taken = 0;  // accesses that the bus has not answered
  unsigned beats = 0, accesses = 0, errors = 0;
  for (unsigned i = 0; i < 20'000; ++i) {
    // Offers stay until they are taken; the first access is a read.
    if (!in.read && happens(tempers.asks)) {
      in.read = {.id = static_cast<std::uint32_t>(random() % 1024),
                 .address = static_cast<std::uint32_t>(random() % (1u << 19)) * 32,
                 .last = static_cast<unsigned>(random() % 8)};
    }
    if (!in.write && accesses > 0 && happens(tempers.asks)) {
      in.write = {.address = static_cast<std::uint32_t>(random() % (1u << 23)) * kBytes,
                  .data = {static_cast<std::uint32_t>(random())},
                  .mask = static_cast<std::uint32_t>(random() % 4)};
    }
    if (in.stop ? model.outputs(in).idle : random() % 2000 == 0) in.stop = !in.stop;
    in.beat_ready = happens(tempers.takes);
    in.stall = happens(tempers.stalls);
    const bool answers = taken > 0 && happens(tempers.answers);
    in.err = answers && happens(tempers.errors);
    in.ack = answers && !in.err;
    in.data = {static_cast<std::uint32_t>(random())};
    const Types::Outputs there = rtl.outputs(in);
    const Types::Outputs here = model.outputs(in);
    ASSERT_TRUE(there == here) << fmt::format("clock {} of seed {}", i, seed);
    rtl.clock(in);
    model.clock(in);
    beats += here.beat && in.beat_ready ? 1 : 0;
    errors += here.error ? 1 : 0;
    const bool takes = here.access && !in.stall;
    accesses += takes ? 1 : 0;
    taken = taken + (takes ? 1 : 0) - (answers ? 1 : 0);
    if (in.read && (here.read_ready || in.stop)) in.read.reset();
    if (in.write && (here.write_ready || in.stop)) in.write.reset();
  }
  EXPECT_GT(beats, 200u);
  EXPECT_GT(accesses, 400u);
  EXPECT_EQ(errors > 0, tempers.errors > 0);
}

constexpr Tempers kTempers[] = {{100, 100, 0, 100, 0},
                                {50, 50, 50, 50, 5},
                                {90, 20, 20, 90, 0},
                                {90, 90, 80, 20, 50},
                                {10, 90, 10, 90, 10}};

TEST(WishboneMemory, IsItsTwinInEachClock) {
  int seed = 0;
  for (const Tempers& tempers : kTempers) {
    run_in_step<Vwishbone_memory_64, 64, 256>(++seed, tempers);
    run_in_step<Vwishbone_memory_3, 3, 5>(++seed, tempers);
  }
}

}  // namespace
}  // namespace dynrt::host::bus
