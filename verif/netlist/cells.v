// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Logic of the core that synthesis for ECP5 turns into block RAMs, multipliers and distributed
// RAMs.
module cells (
  input clk_i, rst_ni,
  input write_en_i, read_en_i,
  input [10:0] write_addr_i, read_addr_i,
  input [35:0] write_data_i,
  output [35:0] wide_o, exclusive_o,
  output [8:0] narrow_o,
  output reg [35:0] registered_wide_o,
  output reg [8:0] registered_narrow_o,
  input signed [17:0] a_i, b_i,
  output signed [35:0] signed_o,
  output [31:0] unsigned_o,
  output reg signed [35:0] registered_o,
  output fifo_valid_o, fifo_ready_o,
  output [7:0] fifo_o,
  output [3:0] rows_o
);
  hls_ram_1r1w #(.WIDTH(36), .ROWS(512), .TORN(1)) wide (
    .clk_i(clk_i), .rst_ni(1'b1), .write_en_i(write_en_i), .write_addr_i(write_addr_i[8:0]),
    .write_data_i(write_data_i), .read_en_i(read_en_i), .read_addr_i(read_addr_i[8:0]),
    .read_data_o(wide_o));
  hls_ram_1r1w #(.WIDTH(36), .ROWS(512)) exclusive (
    .clk_i(clk_i), .rst_ni(1'b1), .write_en_i(write_en_i), .write_addr_i(write_addr_i[8:0]),
    .write_data_i(write_data_i), .read_en_i(read_en_i), .read_addr_i(read_addr_i[8:0]),
    .read_data_o(exclusive_o));
  hls_ram_1r1w #(.WIDTH(9), .ROWS(2048), .TORN(1)) narrow (
    .clk_i(clk_i), .rst_ni(1'b1), .write_en_i(write_en_i), .write_addr_i(write_addr_i),
    .write_data_i(write_data_i[8:0]), .read_en_i(read_en_i), .read_addr_i(read_addr_i),
    .read_data_o(narrow_o));
  wire [35:0] registered_wide;
  wire [8:0] registered_narrow;
  hls_ram_1r1w #(.WIDTH(36), .ROWS(512)) wide_behind (
    .clk_i(clk_i), .rst_ni(1'b1), .write_en_i(write_en_i), .write_addr_i(write_addr_i[8:0]),
    .write_data_i(write_data_i), .read_en_i(read_en_i), .read_addr_i(read_addr_i[8:0]),
    .read_data_o(registered_wide));
  hls_ram_1r1w #(.WIDTH(9), .ROWS(2048)) narrow_behind (
    .clk_i(clk_i), .rst_ni(1'b1), .write_en_i(write_en_i), .write_addr_i(write_addr_i),
    .write_data_i(write_data_i[8:0]), .read_en_i(read_en_i), .read_addr_i(read_addr_i),
    .read_data_o(registered_narrow));
  always @(posedge clk_i) begin
    registered_wide_o <= registered_wide;
    registered_narrow_o <= registered_narrow;
  end
  assign signed_o = a_i * b_i;
  assign unsigned_o = a_i[15:0] * b_i[15:0];
  always @(posedge clk_i) registered_o <= a_i * $signed(write_data_i[17:0]);
  // Six and four of the 16 rows of a distributed RAM; the first is written in each clock.
  hls_fifo #(.WIDTH(8), .DEPTH(6)) fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(write_en_i), .ready_o(fifo_ready_o),
    .data_i(write_data_i[7:0]), .valid_o(fifo_valid_o), .ready_i(read_en_i), .data_o(fifo_o));
  reg [3:0] rows[0:3];
  always @(posedge clk_i) if (write_en_i) rows[write_addr_i[1:0]] <= write_data_i[3:0];
  assign rows_o = rows[read_addr_i[1:0]];
endmodule
