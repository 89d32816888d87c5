// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Brings a reset to a clock: it falls with the one that comes in, at any time, even while the clock
// stands still, and rises with the clock, CLOCKS edges after that one rose. So all registers of the
// clock leave it at the same edge.
//
// Parameters:
//   CLOCKS  edges until it rises, at least 2
//
// Ports:
//   clk_i   the clock
//   rst_ni  reset that may change at any time, active low
//   rst_no  the same, released in step with the clock
`default_nettype none

module hls_reset #(
    parameter CLOCKS = 3
) (
    input  wire clk_i,
    input  wire rst_ni,
    output wire rst_no
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (CLOCKS < 2) begin : bad_clocks
      hls_reset_CLOCKS_must_be_at_least_2 stop ();
    end
  endgenerate

  localparam LAST = CLOCKS > 1 ? CLOCKS - 1 : 1;

  reg [LAST:0] released_q;

  assign rst_no = released_q[LAST];

  always @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) released_q <= {(LAST + 1) {1'b0}};
    else released_q <= {released_q[LAST-1:0], 1'b1};
  end

endmodule

`default_nettype wire
