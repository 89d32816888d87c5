// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Holds both buses of dynrt_wishbone to the rules in every simulation.
`default_nettype none
`include "dynrt_core.vh"

bind dynrt_wishbone wishbone_rules #(
  .ADDRESS_BITS(ADDRESS_BITS), .BYTES(`DYNRT_CORE_MEMORY_BEAT_BYTES)
) memory_rules (
  .clk_i(clk_i), .rst_ni(rst_ni), .cyc(m_wb_cyc_o), .stb(m_wb_stb_o), .we(m_wb_we_o),
  .adr(m_wb_adr_o), .dat_w(m_wb_dat_o), .sel(m_wb_sel_o), .stall(m_wb_stall_i), .ack(m_wb_ack_i),
  .err(m_wb_err_i)
);

bind dynrt_wishbone wishbone_rules #(
  .ADDRESS_BITS(12), .BYTES(4), .SELECTS_NONE(1)
) registers_rules (
  .clk_i(clk_i), .rst_ni(rst_ni), .cyc(s_wb_cyc_i), .stb(s_wb_stb_i), .we(s_wb_we_i),
  .adr(s_wb_adr_i), .dat_w(s_wb_dat_i), .sel(s_wb_sel_i), .stall(s_wb_stall_o), .ack(s_wb_ack_o),
  .err(s_wb_err_o)
);

`default_nettype wire
