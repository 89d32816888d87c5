// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Brings a reset to a clock: it falls with the one that comes in, at any time, even while the clock
// stands still, and rises with the clock, CLOCKS edges after that one rose. So all registers of the
// clock leave it at the same edge. In a large chip one register is too far from some of them, so the
// last two clocks of the way have registers for each part of the chip.
//
// Parameters:
//   CLOCKS  edges until it rises, at least 4
//   PARTS   number of parts of the chip, at least 1
//
// Ports:
//   clk_i   the clock
//   rst_ni  reset that may change at any time, active low
//   rst_no  the same, released in step with the clock, for each part
`default_nettype none

module hls_reset #(
    parameter CLOCKS = 4,
    parameter PARTS  = 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    output wire [PARTS-1:0] rst_no
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (CLOCKS < 4) begin : bad_clocks
      hls_reset_CLOCKS_must_be_at_least_4 stop ();
    end
    if (PARTS < 1) begin : bad_parts
      hls_reset_PARTS_must_be_at_least_1 stop ();
    end
  endgenerate

  localparam LAST = CLOCKS > 3 ? CLOCKS - 3 : 1;

  reg [LAST:0] released_q;

  always @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) released_q <= {(LAST + 1) {1'b0}};
    else released_q <= {released_q[LAST-1:0], 1'b1};
  end

  // Registers of two parts are the same to a synthesis, which would make one of them.
  genvar i;
  generate
    for (i = 0; i < PARTS; i = i + 1) begin : part
      reg [1:0] near_q;
      assign rst_no[i] = near_q[1];
      (* keep *)
      always @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) near_q <= 2'b00;
        else near_q <= {near_q[0], released_q[LAST]};
      end
    end
  endgenerate

endmodule

`default_nettype wire
