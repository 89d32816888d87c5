// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Register file: read in the clock of the address, written at its end. LUT RAM where there is any.
`default_nettype none

module hls_register_file #(
    parameter WIDTH = 8,
    parameter ROWS = 16,
    parameter ADDR_WIDTH = ROWS > 1 ? $clog2(ROWS) : 1
) (
    input  wire                  clk_i,
    input  wire                  write_en_i,
    input  wire [ADDR_WIDTH-1:0] write_addr_i,
    input  wire [     WIDTH-1:0] write_data_i,
    input  wire [ADDR_WIDTH-1:0] read_addr_i,
    output wire [     WIDTH-1:0] read_data_o
);

  reg [WIDTH-1:0] rows[0:ROWS-1];

  assign read_data_o = rows[read_addr_i];

  always @(posedge clk_i) if (write_en_i) rows[write_addr_i] <= write_data_i;

endmodule

`default_nettype wire
