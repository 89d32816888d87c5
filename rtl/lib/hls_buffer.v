// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Two places for tokens, in registers. A token can leave in the clock after it came, and one can
// come in every clock; all outputs come from registers, so that no path leads through.
//
// Parameters:
//   WIDTH  bits of a token, at least 1
//
// Ports:
//   clk_i, rst_ni             clock and synchronous reset, active low
//   valid_i, ready_o, data_i  the stream that comes in
//   valid_o, ready_i, data_o  the stream that goes out, in the same order
`default_nettype none

module hls_buffer #(
    parameter WIDTH = 8
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    input  wire             valid_i,
    output wire             ready_o,
    input  wire [WIDTH-1:0] data_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire [WIDTH-1:0] data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (WIDTH < 1) begin : bad_width
      hls_buffer_WIDTH_must_be_at_least_1 stop ();
    end
  endgenerate

  reg              valid_q;
  reg              full_q;  // a second token waits
  reg  [WIDTH-1:0] data_q;
  reg  [WIDTH-1:0] second_q;
  wire             refill = !valid_q || ready_i;

  assign ready_o = !full_q;
  assign valid_o = valid_q;
  assign data_o  = data_q;

  always @(posedge clk_i) begin
    if (!full_q) second_q <= data_i;
    if (refill) data_q <= full_q ? second_q : data_i;
  end

  always @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= 1'b0;
      full_q  <= 1'b0;
    end else begin
      if (refill) valid_q <= full_q || valid_i;
      full_q <= !refill && (full_q || valid_i);
    end
  end

endmodule

`default_nettype wire
