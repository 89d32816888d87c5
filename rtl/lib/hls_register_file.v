// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Register file: a row is read in the clock of its address and written at the clock's end. It asks
// for LUT RAM, as no block RAM reads in the same clock. Its rows start as zeros: the reset, which
// lasts 2^ADDR_WIDTH clocks or more, clears one a clock.
//
// Parameters:
//   WIDTH       bits of a row, at least 1
//   ROWS        number of rows, at least 1
//   ADDR_WIDTH  bits of an address; follows from ROWS, leave it as it is
//
// Ports:
//   clk_i, rst_ni                           clock and synchronous reset, active low
//   write_en_i, write_addr_i, write_data_i  write port
//   read_addr_i, read_data_o                read port, data in the clock of the address
`default_nettype none

module hls_register_file #(
    parameter WIDTH = 8,
    parameter ROWS = 16,
    parameter ADDR_WIDTH = ROWS > 1 ? $clog2(ROWS) : 1
) (
    input  wire                  clk_i,
    input  wire                  rst_ni,
    input  wire                  write_en_i,
    input  wire [ADDR_WIDTH-1:0] write_addr_i,
    input  wire [     WIDTH-1:0] write_data_i,
    input  wire [ADDR_WIDTH-1:0] read_addr_i,
    output wire [     WIDTH-1:0] read_data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (WIDTH < 1) begin : bad_width
      hls_register_file_WIDTH_must_be_at_least_1 stop ();
    end
    if (ROWS < 1) begin : bad_rows
      hls_register_file_ROWS_must_be_at_least_1 stop ();
    end
    if (ADDR_WIDTH != (ROWS > 1 ? $clog2(ROWS) : 1)) begin : bad_addr_width
      hls_register_file_ADDR_WIDTH_must_follow_from_ROWS stop ();
    end
  endgenerate

  (* ram_style = "distributed" *)  // an FPGA without LUT RAM: docs/how-to/fpga.md
  reg [WIDTH-1:0] rows[0:ROWS-1];
  reg [ADDR_WIDTH-1:0] clear_q;

  wire write_en = write_en_i || !rst_ni;
  wire [ADDR_WIDTH-1:0] write_addr = rst_ni ? write_addr_i : clear_q;

  initial clear_q = {ADDR_WIDTH{1'b0}};
  assign read_data_o = rows[read_addr_i];

  always @(posedge clk_i) begin
    if (write_en) rows[write_addr] <= write_data_i & {WIDTH{rst_ni}};
    if (!rst_ni) clear_q <= clear_q + 1'b1;
  end

endmodule

`default_nettype wire
