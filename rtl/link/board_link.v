// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The link to the host over a serial line (docs/explanation/link.md): the pins, the units of
// dynrt_link, and the bus of the board's registers (board_registers.v). The memory is behind the
// three channels write, read and beat, whose tokens hls/units/link_tokens.h describes; a read that
// is taken behind a write must see it.
//
// Parameters:
//   CLOCK_HZ      of clk_i
//   DIVISOR       clocks of a bit on the line, 4 to 4095
//   MEMORY_BYTES  behind the link
//   NAME          of the configuration, at most 44 letters
//   PIXEL_MHZ     of the display; 0: there is none
`default_nettype none
`include "dynrt_link.vh"

module board_link #(
  parameter [31:0]  CLOCK_HZ = 32'd120000000,
  parameter [11:0]  DIVISOR = 12'd40,
  parameter [31:0]  MEMORY_BYTES = 32'd33554432,
  parameter [351:0] NAME = "thesis",
  parameter [7:0]   PIXEL_MHZ = 8'd0
) (
  input  wire clk_i,
  input  wire rst_ni,
  // pins
  input  wire rx_i,
  output wire tx_o,
  // memory
  output wire write_valid_o,
  input  wire write_ready_i,
  output wire [`DYNRT_LINK_WRITE_BITS-1:0] write_data_o,
  output wire read_valid_o,
  input  wire read_ready_i,
  output wire [`DYNRT_LINK_READ_BITS-1:0] read_data_o,
  input  wire beat_valid_i,
  output wire beat_ready_o,
  input  wire [`DYNRT_LINK_BEAT_BITS-1:0] beat_data_i,
  // bus
  output wire        bus_valid_o,
  output wire        bus_write_o,
  output wire [25:0] bus_addr_o,
  output wire [31:0] bus_wdata_o,
  input  wire        bus_ready_i,
  input  wire        bus_rvalid_i,
  input  wire [31:0] bus_rdata_i
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (DIVISOR < 4) begin : bad_divisor
      board_link_DIVISOR_must_be_at_least_4 stop ();
    end
  endgenerate

  // The first letter lowest; in a Verilog string it is the highest that is not zero.
  function [351:0] letters(input [351:0] text);
    integer i;
    begin
      letters = 352'd0;
      for (i = 0; i < 44; i = i + 1)
        if (text[8*i +: 8] != 8'd0) letters = {letters[343:0], text[8*i +: 8]};
    end
  endfunction
  localparam [511:0] IDENTITY = {
    letters(NAME), {20'd0, DIVISOR}, MEMORY_BYTES, CLOCK_HZ,
    PIXEL_MHZ, `DYNRT_LINK_BEAT_BYTES, 8'd0, `DYNRT_LINK_VERSION, `DYNRT_LINK_MAGIC
  };

  wire sample_valid, sample_ready, sample_data;
  wire bit_valid, bit_ready, bit_data;

  link_pins pins (
    .clk_i(clk_i), .rst_ni(rst_ni), .divisor_i(DIVISOR), .rx_i(rx_i), .tx_o(tx_o),
    .sample_valid_o(sample_valid), .sample_ready_i(sample_ready), .sample_data_o(sample_data),
    .bit_valid_i(bit_valid), .bit_ready_o(bit_ready), .bit_data_i(bit_data)
  );

  // The bus never has more answers than the link has room for, and the link has no counters.
  wire        word_ready;
  wire [31:0] counter_data;
  wire        unused = &{1'b0, word_ready, counter_data};

  dynrt_link link (
    .clk_i(clk_i), .rst_ni(rst_ni),
    .sample_valid_i(sample_valid), .sample_ready_o(sample_ready), .sample_data_i(sample_data),
    .bit_valid_o(bit_valid), .bit_ready_i(bit_ready), .bit_data_o(bit_data),
    .write_valid_o(write_valid_o), .write_ready_i(write_ready_i), .write_data_o(write_data_o),
    .read_valid_o(read_valid_o), .read_ready_i(read_ready_i), .read_data_o(read_data_o),
    .beat_valid_i(beat_valid_i), .beat_ready_o(beat_ready_o), .beat_data_i(beat_data_i),
    .access_valid_o(bus_valid_o), .access_ready_i(bus_ready_i),
    .access_data_o({bus_wdata_o, bus_addr_o, bus_write_o}),
    .word_valid_i(bus_rvalid_i), .word_ready_o(word_ready), .word_data_i(bus_rdata_i),
    .divisor_i(DIVISOR), .identity_i(IDENTITY),
    .counter_clear_i(1'b0), .counter_addr_i(8'd0), .counter_data_o(counter_data)
  );

endmodule

`default_nettype wire
