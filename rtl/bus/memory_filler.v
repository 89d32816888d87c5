// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the core gets of an answer with an error, in place of the data: words that end its way
// through the scene, so that a frame ends whatever the memory does. A node of zeros has no
// children, a matrix of zeros hits nothing, and a list entry of which only the last bit is set is
// the last of its list.
`default_nettype none

module memory_filler #(
  parameter ID_BITS = 10,
  parameter BEAT_BYTES = 16
) (
  input  wire                    clk_i,
  input  wire                    rst_ni,
  input  wire                    taken_i, // the beat
  input  wire [ID_BITS-1:0]      id_i,
  input  wire                    last_i,
  input  wire                    error_i,
  input  wire [8*BEAT_BYTES-1:0] data_i,
  output wire [8*BEAT_BYTES-1:0] data_o
);

  // The lowest bits of an id tell the kind of the item (PortId), of which lists are the second.
  localparam [1:0] LIST = 2'd1;
  wire is_list = id_i[1:0] == LIST;

  wire [8*BEAT_BYTES-1:0] filling;
  generate
    if (BEAT_BYTES == 2) begin : halves
      // Answers begin with the lower half of a word.
      reg upper_q;
      always @(posedge clk_i) begin
        if (taken_i) upper_q <= !upper_q && !last_i;
        if (!rst_ni) upper_q <= 1'b0;
      end
      assign filling = {is_list && upper_q, 15'd0};
    end else begin : words
      assign filling = {BEAT_BYTES / 4{is_list, 31'd0}};
      wire unused = &{1'b0, clk_i, rst_ni, taken_i, last_i};
    end
  endgenerate
  assign data_o = error_i ? filling : data_i;

  wire unused = &{1'b0, id_i};

endmodule

`default_nettype wire
