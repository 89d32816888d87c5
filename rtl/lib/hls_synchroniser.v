// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Brings a signal of another clock, or of none, into this one: two flip-flops, of which the first may
// be metastable for a clock. For one bit; the bits of a word may arrive a clock apart.
//
// Parameters:
//   RESET  the value while rst_ni is low, 0 to 1
//
// Ports:
//   clk_i, rst_ni  clock and synchronous reset, active low
//   data_i         the signal, at any time
//   data_o         the same, two clocks later
`default_nettype none

module hls_synchroniser #(
    parameter RESET = 0
) (
    input  wire clk_i,
    input  wire rst_ni,
    input  wire data_i,
    output wire data_o
);

  generate
    if (RESET != 0 && RESET != 1) begin : bad_reset
      hls_synchroniser_RESET_must_be_0_or_1 stop ();
    end
  endgenerate

  (* keep, async_reg = "true" *) reg [1:0] data_q;
  assign data_o = data_q[1];

  always @(posedge clk_i) begin
    if (!rst_ni) data_q <= {2{RESET != 0}};
    else data_q <= {data_q[0], data_i};
  end

endmodule

`default_nettype wire
