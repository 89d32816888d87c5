// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// In the place of hls_delay where two units are compared: registers one after another, which hold
// nothing that is older than CLOCKS, as an induction needs. The proof hls_delay says that the ring
// of the library does the same.
`default_nettype none

module hls_delay #(
    parameter WIDTH  = 8,
    parameter CLOCKS = 8
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    input  wire [WIDTH-1:0] data_i,
    output wire [WIDTH-1:0] data_o
);

  reg [WIDTH*CLOCKS-1:0] words_q;
  wire [WIDTH*(CLOCKS+1)-1:0] words = {words_q, data_i};
  assign data_o = words[WIDTH*CLOCKS+:WIDTH];
  always @(posedge clk_i) words_q <= words[WIDTH*CLOCKS-1:0];

endmodule

// A signal CLOCKS clocks ago, any number of them; zero if that was before the reset's end.
module past #(
    parameter WIDTH  = 1,
    parameter CLOCKS = 0
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    input  wire [WIDTH-1:0] data_i,
    output wire [WIDTH-1:0] data_o
);

  generate
    if (CLOCKS == 0) begin : now
      assign data_o = data_i;
    end else begin : before
      reg [WIDTH*CLOCKS-1:0] words_q;
      wire [WIDTH*(CLOCKS+1)-1:0] words = {words_q, data_i};
      assign data_o = words[WIDTH*CLOCKS+:WIDTH];
      always @(posedge clk_i) words_q <= rst_ni ? words[WIDTH*CLOCKS-1:0] : {WIDTH * CLOCKS{1'b0}};
    end
  endgenerate

endmodule

`default_nettype wire
