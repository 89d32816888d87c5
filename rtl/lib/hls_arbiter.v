// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Merges INPUTS streams into one, round robin. The grant is a register, so that no input's valid is
// on the way of the data: in each clock the granted input may send, and the next waiting input
// after it, if there is one, gets the grant for the clock that follows. The grant stays where no
// other input waits: a lone stream sends in every clock, and a token that comes without the grant
// waits for one clock. Input 0 is the lowest bits of valid_i, ready_o and data_i.
//
// Parameters:
//   INPUTS  streams that come in, at least 1
//   WIDTH   bits of a token, at least 1
//
// Ports:
//   clk_i, rst_ni             clock and synchronous reset, active low; it grants input 0
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

  reg     [INPUTS-1:0] grant_q;  // one bit is set
  reg     [INPUTS-1:0] after;  // the inputs after the granted one
  reg     [INPUTS-1:0] next;  // the first of those that wait
  reg                  found, passed;
  wire    [INPUTS-1:0] waiting = valid_i & ~grant_q;
  wire    [INPUTS-1:0] first = waiting & after;
  wire    [INPUTS-1:0] pick = (|first) ? first : waiting;
  integer              i;

  assign valid_o = |(valid_i & grant_q);
  assign ready_o = grant_q & {INPUTS{ready_i}};

  always @* begin
    data_o = {WIDTH{1'b0}};
    passed = 1'b0;
    found = 1'b0;
    for (i = 0; i < INPUTS; i = i + 1) begin
      data_o = data_o | (data_i[i*WIDTH+:WIDTH] & {WIDTH{grant_q[i]}});
      after[i] = passed;
      passed = passed || grant_q[i];
      next[i] = pick[i] && !found;
      found = found || pick[i];
    end
  end

  always @(posedge clk_i) begin
    if (!rst_ni) grant_q <= ONE;
    else if (ready_i && |waiting) grant_q <= next;
  end

endmodule

`default_nettype wire
