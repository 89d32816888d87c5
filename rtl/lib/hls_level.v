// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Brings a signal to a clock through registers, the first of which may take time to settle. The
// signal must hold still for longer than a period of the clock; several do not arrive together.
//
// Parameters:
//   CLOCKS  registers on its way, at least 2
//
// Ports:
//   clk_i    the clock that it comes to
//   level_i  the signal, from any clock
//   level_o  the same, so many clocks later
`default_nettype none

module hls_level #(
    parameter CLOCKS = 2
) (
    input  wire clk_i,
    input  wire level_i,
    output wire level_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (CLOCKS < 2) begin : bad_clocks
      hls_level_CLOCKS_must_be_at_least_2 stop ();
    end
  endgenerate

  localparam LAST = CLOCKS > 1 ? CLOCKS - 1 : 1;

  reg [LAST:0] level_q;

  assign level_o = level_q[LAST];

  always @(posedge clk_i) level_q <= {level_q[LAST-1:0], level_i};

endmodule

`default_nettype wire
