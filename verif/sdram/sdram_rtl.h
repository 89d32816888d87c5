// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The Verilated sdram_port with the functions of its native model (units/sdram_port.h).
#pragma once

#include <verilated.h>

#include <cstdint>
#include <cstring>
#include <memory>

#include "units/sdram_port.h"

namespace dynrt::verif {

template <class V, unsigned PortBytes>
class SdramRtl {
 public:
  using Types = SdramPortTypes<PortBytes>;
  using Inputs = typename Types::Inputs;
  using Outputs = typename Types::Outputs;
  static constexpr unsigned kResetClocks = 16;  ///< the rows of the largest register file

  /// Registers begin with random values.
  SdramRtl(unsigned pause_turns, int seed) {
    context_.randReset(2);
    context_.randSeed(seed);
    v_ = std::make_unique<V>(&context_);
    set(v_->pause_i, pause_turns);
    v_->rst_ni = 0;
    for (unsigned i = 0; i < kResetClocks; ++i) clock({});
    v_->rst_ni = 1;
  }

  /// The outputs in a clock with these inputs.
  Outputs outputs(const Inputs& in) {
    drive(in);
    settle();
    Outputs out;
    out.read_ready = v_->read_ready_o != 0;
    out.write_ready = v_->write_ready_o != 0;
    if (v_->beat_valid_o != 0) {
      typename Types::Beat beat{.id = v_->beat_id_o, .data = {}, .last = v_->beat_last_o != 0};
      copy(beat.data.data(), v_->beat_data_o);
      out.beat = beat;
    }
    const unsigned command = v_->sdram_ras_no | v_->sdram_cas_no << 1 | v_->sdram_we_no << 2;
    out.pins = {static_cast<SdramCommand>(command),
                v_->sdram_ba_o,
                v_->sdram_a_o,
                v_->sdram_dqm_o,
                v_->sdram_dq_float_o == 0,
                v_->sdram_dq_float_o == 0 ? v_->sdram_dq_o : std::uint16_t{0}};
    return out;
  }
  void clock(const Inputs& in) {
    drive(in);
    settle();
    v_->clk_i = 1;
    v_->eval();
  }

 private:
  void settle() {
    v_->clk_i = 0;
    v_->eval();
  }
  void drive(const Inputs& in) {
    v_->read_valid_i = in.read.has_value();
    const auto read = in.read.value_or(typename Types::Read{~0u, ~0u, 15});
    set(v_->read_id_i, read.id & 0x3ff);
    set(v_->read_address_i, read.address & 0x1ff'ffff);
    set(v_->read_last_i, read.last & 15);
    v_->write_valid_i = in.write.has_value();
    const auto write = in.write.value_or(typename Types::Write{~0u, {}, ~0u});
    set(v_->write_address_i, write.address & 0x1ff'ffff);
    set(v_->write_mask_i, write.mask & ((1u << Types::kHalves) - 1));
    copy(v_->write_data_i, write.data.data());
    v_->beat_ready_i = in.beat_ready;
    v_->sdram_dq_i = in.dq;
  }
  template <class Number>
  static void set(Number& pin, std::uint32_t value) {
    pin = static_cast<Number>(value);
  }
  template <class Wide>
  static void copy(Wide& to, const std::uint16_t* from) {
    std::memcpy(&to, from, PortBytes);
  }
  template <class Wide>
  static void copy(std::uint16_t* to, const Wide& from) {
    std::memcpy(to, &from, PortBytes);
  }

  VerilatedContext context_;
  std::unique_ptr<V> v_;
};

}  // namespace dynrt::verif
