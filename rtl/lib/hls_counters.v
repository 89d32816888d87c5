// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A bank of up to 256 32-bit event counters, read one at a time: data_o is the counter of the address that
// stood a clock before. Counters wrap; clear_i sets all to zero.
`default_nettype none

module hls_counters #(
    parameter COUNTERS = 1
) (
    input  wire                clk_i,
    input  wire                rst_ni,
    input  wire                clear_i,
    input  wire [7:0]          addr_i,
    output reg  [31:0]         data_o,
    input  wire [COUNTERS-1:0] event_i
);

  wire [31:0] count[0:255];

  genvar i;
  generate
    for (i = 0; i < 256; i = i + 1) begin : counter
      if (i < COUNTERS) begin : counted
        reg [31:0] count_q;
        assign count[i] = count_q;
        always @(posedge clk_i) begin
          if (!rst_ni || clear_i) count_q <= 32'd0;
          else if (event_i[i]) count_q <= count_q + 32'd1;
        end
      end else begin : absent
        assign count[i] = 32'd0;
      end
    end
  endgenerate

  always @(posedge clk_i) data_o <= count[addr_i];

endmodule

`default_nettype wire
