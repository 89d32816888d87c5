// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Delay of CLOCKS clocks (at least 3): a ring of CLOCKS - 1 rows in LUT RAM and an output register.
//
// Parameters:
//   WIDTH   bits of the value, at least 1
//   CLOCKS  clocks from data_i to data_o, at least 3
//
// Ports:
//   clk_i, rst_ni  clock and synchronous reset, active low; the reset does not clear the rows
//   data_i         the input value, one in every clock
//   data_o         the value of data_i CLOCKS clocks before
`default_nettype none

module hls_delay #(
    parameter WIDTH  = 8,
    parameter CLOCKS = 8
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    input  wire [WIDTH-1:0] data_i,
    output reg  [WIDTH-1:0] data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (WIDTH < 1) begin : bad_width
      hls_delay_WIDTH_must_be_at_least_1 stop ();
    end
    if (CLOCKS < 3) begin : bad_clocks
      hls_delay_CLOCKS_must_be_at_least_3 stop ();
    end
  endgenerate

  localparam ADDR_WIDTH = $clog2(CLOCKS - 1);
  localparam [31:0] LAST = CLOCKS - 2;

  reg [WIDTH-1:0] rows[0:CLOCKS-2];
  reg [ADDR_WIDTH-1:0] row_q;

  always @(posedge clk_i) begin
    rows[row_q] <= data_i;
    data_o <= rows[row_q];
  end

  // Without a carry chain, which would take more LUTs: a bit flips where all below it are ones.
  wire [ADDR_WIDTH-1:0] flips;
  genvar i;
  generate
    assign flips[0] = 1'b1;
    for (i = 1; i < ADDR_WIDTH; i = i + 1) begin : others
      assign flips[i] = &row_q[i-1:0];
    end
  endgenerate

  always @(posedge clk_i) begin
    if (!rst_ni || row_q == LAST[ADDR_WIDTH-1:0]) row_q <= {ADDR_WIDTH{1'b0}};
    else row_q <= row_q ^ flips;
  end

endmodule

`default_nettype wire
