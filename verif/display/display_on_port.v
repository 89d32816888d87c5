// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A display on a DVI link whose picture lies in a memory behind a port.
`default_nettype none
`include "dynrt_core.vh"

module display_on_port #(
  parameter BEAT_BYTES = `DYNRT_CORE_MEMORY_BEAT_BYTES,
  parameter PIXEL_BYTES = `DYNRT_CORE_MEMORY_PIXEL_BYTES,
  parameter AHEAD = 64
) (
  input  wire                    clk_i,
  input  wire                    rst_ni,
  input  wire                    osc_i,
  input  wire                    on_i,
  input  wire [447:0]            config_i,
  output wire                    running_o,
  output wire [19:0]             shown_o,
  output wire [31:0]             frames_o,
  output wire                    starved_o,
  output wire                    underrun_o,
  output wire                    read_valid_o,
  input  wire                    read_ready_i,
  output wire [24:0]             read_address_o,
  output wire [3:0]              read_last_o,
  input  wire                    beat_valid_i,
  output wire                    beat_ready_o,
  input  wire [8*BEAT_BYTES-1:0] beat_data_i,
  input  wire                    beat_last_i,
  output wire [3:0]              dvi_p_o,
  output wire [3:0]              dvi_n_o
);

  wire        begins, bank_en;
  wire [19:0] base, address_unused;
  wire [31:0] bank_data;

  ecp5_display display (
    .clk_i(clk_i), .rst_ni(rst_ni), .osc_i(osc_i), .on_i(on_i), .config_i(config_i),
    .running_o(running_o), .shown_o(shown_o), .begins_o(begins), .base_o(base),
    .frames_o(frames_o), .starved_o(starved_o), .bank_en_o(bank_en),
    .bank_addr_o(address_unused), .bank_data_i(bank_data), .dvi_p_o(dvi_p_o), .dvi_n_o(dvi_n_o)
  );

  picture_stream #(
    .BEAT_BYTES(BEAT_BYTES), .PIXEL_BYTES(PIXEL_BYTES), .AHEAD(AHEAD)
  ) picture (
    .clk_i(clk_i), .rst_ni(rst_ni), .running_i(running_o), .config_i(config_i),
    .begins_i(begins), .base_i(base), .bank_en_i(bank_en), .bank_data_o(bank_data),
    .underrun_o(underrun_o), .read_valid_o(read_valid_o), .read_ready_i(read_ready_i),
    .read_address_o(read_address_o), .read_last_o(read_last_o), .beat_valid_i(beat_valid_i),
    .beat_ready_o(beat_ready_o), .beat_data_i(beat_data_i), .beat_last_i(beat_last_i)
  );

endmodule

`default_nettype wire
