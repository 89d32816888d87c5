// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Repeats a job: a token whose lowest COUNT_WIDTH bits hold n leaves n + 1 times, with its number
// (lowest) and a last flag put below it.
//
// Parameters:
//   WIDTH        bits of a job, at least COUNT_WIDTH
//   COUNT_WIDTH  bits of the count, the lowest of the job; at least 1
//
// Ports:
//   clk_i, rst_ni             clock and synchronous reset, active low
//   valid_i, ready_o, data_i  the jobs
//   valid_o, ready_i, data_o  {job, last flag, number}, n + 1 times for each job
`default_nettype none

module hls_repeat #(
    parameter WIDTH = 8,
    parameter COUNT_WIDTH = 2
) (
    input  wire                         clk_i,
    input  wire                         rst_ni,
    input  wire                         valid_i,
    output wire                         ready_o,
    input  wire [WIDTH-1:0]             data_i,
    output wire                         valid_o,
    input  wire                         ready_i,
    output wire [WIDTH+COUNT_WIDTH:0]   data_o
);

  // A module that does not exist, and whose name is the message, stops elaboration.
  generate
    if (COUNT_WIDTH < 1) begin : bad_count_width
      hls_repeat_COUNT_WIDTH_must_be_at_least_1 stop ();
    end
    if (WIDTH < COUNT_WIDTH) begin : bad_width
      hls_repeat_WIDTH_must_be_at_least_COUNT_WIDTH stop ();
    end
  endgenerate

  reg [COUNT_WIDTH-1:0] number_q;

  wire last = number_q == data_i[COUNT_WIDTH-1:0];

  assign valid_o = valid_i;
  assign ready_o = ready_i && last;
  assign data_o  = {data_i, last, number_q};

  always @(posedge clk_i) begin
    if (!rst_ni) number_q <= {COUNT_WIDTH{1'b0}};
    else if (valid_i && ready_i) number_q <= last ? {COUNT_WIDTH{1'b0}} : number_q + 1'b1;
  end

endmodule

`default_nettype wire
