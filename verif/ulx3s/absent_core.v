// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Takes the place of a core in tests of a board alone: it takes nothing and asks for nothing.
`default_nettype none
`include "dynrt_core.vh"

module dynrt_core (
  input  wire        clk_i,
  input  wire        rst_ni,
  input  wire        start_valid_i,
  output wire        start_ready_o,
  input  wire [9:0]  start_data_i,
  output wire        done_valid_o,
  input  wire        done_ready_i,
  output wire        done_data_o,
  input  wire [`DYNRT_CORE_FRAME_BITS-1:0] frame_i,
  output wire        memory_read_valid_o,
  input  wire        memory_read_ready_i,
  output wire [`DYNRT_CORE_MEMORY_ID_BITS+27:0] memory_read_data_o,
  input  wire        memory_beat_valid_i,
  output wire        memory_beat_ready_o,
  input  wire [8*`DYNRT_CORE_MEMORY_BEAT_BYTES+`DYNRT_CORE_MEMORY_ID_BITS:0] memory_beat_data_i,
  output wire        memory_write_valid_o,
  input  wire        memory_write_ready_i,
  output wire [17*`DYNRT_CORE_MEMORY_BEAT_BYTES/2+27:0] memory_write_data_o,
  input  wire [7:0]  counter_addr_i,
  output wire [31:0] counter_data_o,
  input  wire        counter_clear_i
);

  assign start_ready_o = 1'b0;
  assign done_valid_o = 1'b0;
  assign done_data_o = 1'b0;
  assign memory_read_valid_o = 1'b0;
  assign memory_read_data_o = 0;
  assign memory_beat_ready_o = 1'b0;
  assign memory_write_valid_o = 1'b0;
  assign memory_write_data_o = 0;
  assign counter_data_o = 32'd0;

endmodule

`default_nettype wire
