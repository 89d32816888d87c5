// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The unit of tally.h by hand: 3 stages that never stall behind credits, and a FIFO of 8 at every
// output. bug_i other than 0 makes one of the mistakes that the bench must find.
module tally_fifo #(parameter WIDTH = 8) (
  input clk_i, input rst_ni,
  input push_i, input [WIDTH-1:0] data_i, output [3:0] count_o,
  output valid_o, input ready_i, output [WIDTH-1:0] data_o
);
  reg [WIDTH-1:0] rows [0:7];
  reg [3:0] head_q, tail_q;
  assign count_o = tail_q - head_q;
  assign valid_o = tail_q != head_q;
  assign data_o = rows[head_q[2:0]];
  always @(posedge clk_i) begin
    if (push_i) rows[tail_q[2:0]] <= data_i;
    if (!rst_ni) begin
      head_q <= 0;
      tail_q <= 0;
    end else begin
      if (push_i) tail_q <= tail_q + 1;
      if (valid_o && ready_i) head_q <= head_q + 1;
    end
  end
endmodule

module tally (
  input clk_i, input rst_ni,
  input [3:0] bug_i,
  input job_valid_i, output job_ready_o, input [98:0] job_data_i,
  input extra_valid_i, output extra_ready_o, input [6:0] extra_data_i,
  input [8:0] offset_i,
  output table_en_o, output [4:0] table_addr_o, input [39:0] table_data_i,
  output result_valid_o, input result_ready_i, output [107:0] result_data_o,
  output copy_0_valid_o, input copy_0_ready_i, output [4:0] copy_0_data_o,
  output copy_1_valid_o, input copy_1_ready_i, output [4:0] copy_1_data_o,
  output last_en_o, output [3:0] last_addr_o, output [15:0] last_data_o
);
  localparam LOW_BIT = 1, LATE_ROW = 2, WRONG_ROW = 3, DROPPED = 4, EXTRA = 5, UNSTEADY = 6,
             RETRACTED = 7, DEADLOCK = 8, NO_WRITE = 9, NO_CONFIG = 10, STAMP = 11;

  // Accept a token of each only if whatever is under way finds a place behind.
  wire [3:0] result_count, copy_0_count, copy_1_count;
  reg valid1_q, valid2_q;
  wire room = result_count < 5 && copy_0_count < 5 && copy_1_count < 5;
  reg [9:0] accepted_q;
  wire take = job_valid_i && extra_valid_i && room && !(bug_i == DEADLOCK && accepted_q == 10'd900);
  assign job_ready_o = take;
  assign extra_ready_o = take;
  assign table_en_o = take;
  assign table_addr_o = job_data_i[10:6];

  // The row comes two clocks after the address.
  reg [98:0] job1_q, job2_q;
  reg [6:0] extra1_q, extra2_q;
  reg [15:0] before_q;
  reg [15:0] totals [0:15];
  reg [39:0] row_q;
  integer i;
  initial for (i = 0; i < 16; i = i + 1) totals[i] = 0;
  wire [39:0] row = bug_i == LATE_ROW ? row_q : table_data_i;
  wire [3:0] packet = job2_q[3:0];
  wire [1:0] action = job2_q[5:4];
  wire [4:0] address = job2_q[10:6];
  wire [15:0] sum = before_q + row[15:0] + {9'd0, extra2_q} +
                    (bug_i == NO_CONFIG ? 16'd0 : {7'd0, offset_i});
  wire [15:0] total = (action == 0 ? sum : row[15:0]) ^ (bug_i == LOW_BIT && address == 5'd17 ? 16'd1 : 16'd0);
  always @(posedge clk_i) begin
    row_q <= table_data_i;
    if (!rst_ni) begin
      valid1_q <= 0;
      valid2_q <= 0;
      accepted_q <= 0;
    end else begin
      valid1_q <= take;
      valid2_q <= valid1_q;
      if (take) accepted_q <= accepted_q + 1;
    end
    job1_q <= job_data_i;
    extra1_q <= extra_data_i;
    job2_q <= job1_q;
    extra2_q <= extra1_q;
    before_q <= totals[job1_q[3:0]];
    if (valid2_q) totals[packet] <= total;
  end

  wire speaks = valid2_q && action != 3;
  wire gives = (speaks && action != 2 && !(bug_i == DROPPED && accepted_q == 10'd700)) ||
               (bug_i == EXTRA && speaks && action == 2 && address == 5'd3);
  wire [63:0] stamp = job2_q[98:35] ^ {40'd0, row[39:16]} ^ (bug_i == STAMP ? 64'h8000_0000_0000_0000 : 64'd0);
  wire [107:0] result = {stamp, ~job2_q[34], job2_q[33:11], total, packet};
  wire result_valid;
  wire [107:0] result_data;
  tally_fifo #(.WIDTH(108)) result_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .push_i(gives), .data_i(result), .count_o(result_count),
    .valid_o(result_valid), .ready_i(result_ready_i), .data_o(result_data));
  reg toggle_q;
  always @(posedge clk_i) toggle_q <= rst_ni && !toggle_q;
  assign result_valid_o = result_valid && !(bug_i == RETRACTED && toggle_q && !result_ready_i);
  assign result_data_o = result_data ^ {107'd0, bug_i == UNSTEADY && toggle_q && !result_ready_i};

  tally_fifo #(.WIDTH(5)) copy_0_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .push_i(speaks && !address[0]), .data_i(address),
    .count_o(copy_0_count), .valid_o(copy_0_valid_o), .ready_i(copy_0_ready_i),
    .data_o(copy_0_data_o));
  tally_fifo #(.WIDTH(5)) copy_1_fifo (
    .clk_i(clk_i), .rst_ni(rst_ni), .push_i(speaks && address[0]), .data_i(address),
    .count_o(copy_1_count), .valid_o(copy_1_valid_o), .ready_i(copy_1_ready_i),
    .data_o(copy_1_data_o));

  assign last_en_o = speaks && action == 1 && bug_i != NO_WRITE;
  assign last_addr_o = packet ^ (bug_i == WRONG_ROW && address == 5'd9 ? 4'd1 : 4'd0);
  assign last_data_o = total;
endmodule
