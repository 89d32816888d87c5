// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// dynrt_wishbone beside a memory: on-chip RAM that never stalls. The registers go to whatever has
// the processor.
`default_nettype none
`include "dynrt_core.vh"

module wishbone_system (
  input  wire clk_i,
  input  wire rst_ni,
  output wire irq_o,
  input  wire s_wb_cyc_i,
  input  wire s_wb_stb_i,
  input  wire s_wb_we_i,
  input  wire [11:0] s_wb_adr_i,
  input  wire [31:0] s_wb_dat_i,
  input  wire [3:0] s_wb_sel_i,
  output wire s_wb_stall_o,
  output wire s_wb_ack_o,
  output wire s_wb_err_o,
  output wire [31:0] s_wb_dat_o
);

  localparam BYTES = `DYNRT_CORE_MEMORY_BEAT_BYTES, ROWS_LOG2 = 12;
  wire               cyc, stb, we;
  wire [31:0]        adr;
  wire [8*BYTES-1:0] dat_w;
  wire [BYTES-1:0]   sel;
  reg                ack;
  reg  [8*BYTES-1:0] dat_r;

  dynrt_wishbone #(.MEMORY_BASE(64'h4000_0000)) renderer (
    .clk_i(clk_i), .rst_ni(rst_ni), .irq_o(irq_o), .s_wb_cyc_i(s_wb_cyc_i),
    .s_wb_stb_i(s_wb_stb_i), .s_wb_we_i(s_wb_we_i), .s_wb_adr_i(s_wb_adr_i),
    .s_wb_dat_i(s_wb_dat_i), .s_wb_sel_i(s_wb_sel_i), .s_wb_stall_o(s_wb_stall_o),
    .s_wb_ack_o(s_wb_ack_o), .s_wb_err_o(s_wb_err_o), .s_wb_dat_o(s_wb_dat_o), .m_wb_cyc_o(cyc),
    .m_wb_stb_o(stb), .m_wb_we_o(we), .m_wb_adr_o(adr), .m_wb_dat_o(dat_w), .m_wb_sel_o(sel),
    .m_wb_stall_i(1'b0), .m_wb_ack_i(ack), .m_wb_err_i(1'b0), .m_wb_dat_i(dat_r)
  );

  reg [8*BYTES-1:0] rows [0:(1<<ROWS_LOG2)-1];
  wire [ROWS_LOG2-1:0] row = adr[$clog2(BYTES) +: ROWS_LOG2];
  integer i;
  always @(posedge clk_i) begin
    ack <= rst_ni && cyc && stb;
    dat_r <= rows[row];
    for (i = 0; i < BYTES; i = i + 1)
      if (cyc && stb && we && sel[i]) rows[row][8*i +: 8] <= dat_w[8*i +: 8];
  end

  wire unused = &{1'b0, adr};

endmodule

`default_nettype wire
