// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Merges INPUTS streams into one, round robin: after input i has sent a token, the inputs after it
// come first. An offered token stays offered until it is taken, even if other tokens come. Input 0
// is the lowest bits of valid_i, ready_o and data_i.
//
// Parameters:
//   INPUTS  streams that come in, at least 1
//   WIDTH   bits of a token, at least 1
//
// Ports:
//   clk_i, rst_ni             clock and synchronous reset, active low
//   valid_i, ready_o, data_i  the streams that come in, one bit (one token) for each
//   valid_o, ready_i, data_o  the stream that goes out
`default_nettype none

module hls_arbiter #(
    parameter INPUTS = 2,
    parameter WIDTH  = 8
) (
    input  wire                    clk_i,
    input  wire                    rst_ni,
    input  wire [      INPUTS-1:0] valid_i,
    output wire [      INPUTS-1:0] ready_o,
    input  wire [INPUTS*WIDTH-1:0] data_i,
    output wire                    valid_o,
    input  wire                    ready_i,
    output reg  [       WIDTH-1:0] data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (INPUTS < 1) begin : bad_inputs
      hls_arbiter_INPUTS_must_be_at_least_1 stop ();
    end
    if (WIDTH < 1) begin : bad_width
      hls_arbiter_WIDTH_must_be_at_least_1 stop ();
    end
  endgenerate

  localparam [INPUTS-1:0] ONE = 1;

  reg     [INPUTS-1:0] after_q;  // the inputs after the one that sent last
  reg     [INPUTS-1:0] offered_q;  // the input whose token waits for ready_i
  wire    [INPUTS-1:0] first = valid_i & after_q;
  wire    [INPUTS-1:0] pick = (|first) ? first : valid_i;
  wire    [INPUTS-1:0] grant = (|offered_q) ? offered_q : pick & (~pick + ONE);
  integer              i;

  assign valid_o = |valid_i;
  assign ready_o = grant & {INPUTS{ready_i}};

  always @* begin
    data_o = {WIDTH{1'b0}};
    for (i = 0; i < INPUTS; i = i + 1) begin
      data_o = data_o | (data_i[i*WIDTH+:WIDTH] & {WIDTH{grant[i]}});
    end
  end

  always @(posedge clk_i) begin
    if (!rst_ni) after_q <= {INPUTS{1'b0}};
    else if (valid_o && ready_i) after_q <= ~(grant | (grant - ONE));
  end

  always @(posedge clk_i) begin
    if (!rst_ni) offered_q <= {INPUTS{1'b0}};
    else offered_q <= ready_i ? {INPUTS{1'b0}} : grant;
  end

endmodule

`default_nettype wire
