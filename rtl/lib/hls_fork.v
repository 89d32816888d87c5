// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Gives every token to all OUTPUTS readers in the same clock, when all of them are ready. No
// reader's ready may depend on its own valid. It is logic alone, hence without clock and reset.
//
// Parameters:
//   OUTPUTS  readers, at least 1
//   WIDTH    bits of a token, at least 1
//
// Ports:
//   valid_i, ready_o, data_i  the stream that comes in
//   valid_o, ready_i          handshake with each reader, reader 0 in the lowest bit
//   data_o                    the token, for all readers
`default_nettype none

module hls_fork #(
    parameter OUTPUTS = 2,
    parameter WIDTH   = 8
) (
    input  wire               valid_i,
    output wire               ready_o,
    input  wire [  WIDTH-1:0] data_i,
    output wire [OUTPUTS-1:0] valid_o,
    input  wire [OUTPUTS-1:0] ready_i,
    output wire [  WIDTH-1:0] data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (OUTPUTS < 1) begin : bad_outputs
      hls_fork_OUTPUTS_must_be_at_least_1 stop ();
    end
    if (WIDTH < 1) begin : bad_width
      hls_fork_WIDTH_must_be_at_least_1 stop ();
    end
  endgenerate

  assign ready_o = &ready_i;
  assign data_o  = data_i;

  genvar i;
  generate
    for (i = 0; i < OUTPUTS; i = i + 1) begin : reader
      // A reader's valid leaves out its own ready, so that this ready may depend on logic that
      // reads valid.
      localparam [OUTPUTS-1:0] SELF = {{(OUTPUTS - 1) {1'b0}}, 1'b1} << i;
      assign valid_o[i] = valid_i && (&(ready_i | SELF));
    end
  endgenerate

endmodule

`default_nettype wire
