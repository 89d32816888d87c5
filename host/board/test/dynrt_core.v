// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A stand-in for the core with the core's ports, for tests of the board alone; it traces no rays.
// It waits for all start tokens in order (lines, packets), then for word p of frame words width * height it reads
// banks 0 to 2 at p and writes
//   bank 3 [frame_base + p] = bank 0 ^ bank 1, bank 4 [p] = bank 2, bank 5 [p] = ~bank 0
// one word a clock, or, where frame word scanline is 1, one in two clocks, as shading does.
// Counters: 0 the words written, 1 the start tokens. A background of 32'hdeadbeef makes it hang after
// the last write, one of 32'h00badbad violates an assertion.
`include "dynrt_core.vh"

module dynrt_core (
  input  wire          clk_i,
  input  wire          rst_ni,
  input  wire          start_valid_i,
  output wire          start_ready_o,
  input  wire [9:0]    start_data_i,
  output wire          done_valid_o,
  input  wire          done_ready_i,
  output wire          done_data_o,
  input  wire [`DYNRT_CORE_FRAME_BITS-1:0] frame_i,
  output wire          bank0_en_o,
  output wire [19:0]   bank0_addr_o,
  input  wire [31:0]   bank0_data_i,
  output wire          bank1_en_o,
  output wire [19:0]   bank1_addr_o,
  input  wire [31:0]   bank1_data_i,
  output wire          bank2_en_o,
  output wire [19:0]   bank2_addr_o,
  input  wire [31:0]   bank2_data_i,
  output wire          bank3_en_o,
  output wire [19:0]   bank3_addr_o,
  output wire [31:0]   bank3_data_o,
  output wire          bank4_en_o,
  output wire [19:0]   bank4_addr_o,
  output wire [31:0]   bank4_data_o,
  output wire          bank5_en_o,
  output wire [19:0]   bank5_addr_o,
  output wire [31:0]   bank5_data_o,
  input  wire [7:0]    counter_addr_i,
  output reg  [31:0]   counter_data_o,
  input  wire          counter_clear_i
);

  localparam LATENCY = 3;

  wire [31:0] packets = frame_i[`DYNRT_CORE_FRAME_PACKETS +: 32];
  wire [31:0] lines = frame_i[`DYNRT_CORE_FRAME_LINE_MASK +: 32] + 32'd1;
  wire [31:0] width = frame_i[`DYNRT_CORE_FRAME_WIDTH +: 32];
  wire [31:0] height = frame_i[`DYNRT_CORE_FRAME_HEIGHT +: 32];
  wire [31:0] background = frame_i[`DYNRT_CORE_FRAME_BACKGROUND +: 32];
  wire [19:0] frame_base = frame_i[`DYNRT_CORE_FRAME_FRAME_BASE +: 20];
  wire [63:0] words = {32'd0, width} * {32'd0, height};

  reg  [31:0] tokens_q;
  reg  [19:0] next_q;
  reg         done_q;
  reg         pace_q;
  reg  [31:0] written_q;
  reg  [LATENCY-1:0]    valid_q;
  reg  [20*LATENCY-1:0] word_q;

  wire fed = tokens_q == lines + packets;
  wire [31:0] token = tokens_q < lines ? tokens_q : `DYNRT_CORE_FIRST_PACKET + tokens_q - lines;
  wire pace = !frame_i[`DYNRT_CORE_FRAME_SCANLINE] || !pace_q;
  wire issue = fed && pace && {44'd0, next_q} < words;
  wire write = valid_q[LATENCY-1];
  wire [19:0] word = word_q[20*(LATENCY-1) +: 20];

  assign start_ready_o = 1'b1;
  assign done_valid_o = fed && {32'd0, written_q} == words && !done_q && background != 32'hdeadbeef;
  assign done_data_o = 1'b0;
  assign bank0_en_o = issue;
  assign bank1_en_o = issue;
  assign bank2_en_o = issue;
  assign bank0_addr_o = next_q;
  assign bank1_addr_o = next_q;
  assign bank2_addr_o = next_q;
  assign bank3_en_o = write;
  assign bank4_en_o = write;
  assign bank5_en_o = write;
  assign bank3_addr_o = word + frame_base;
  assign bank4_addr_o = word;
  assign bank5_addr_o = word;
  assign bank3_data_o = bank0_data_i ^ bank1_data_i;
  assign bank4_data_o = bank2_data_i;
  assign bank5_data_o = ~bank0_data_i;

  always @(posedge clk_i) begin
    // A token out of order is never counted, so the board's test sees a hang.
    if (start_valid_i && {22'd0, start_data_i} == token) tokens_q <= tokens_q + 32'd1;
    pace_q <= !pace_q;
    if (issue) next_q <= next_q + 20'd1;
    if (write) written_q <= written_q + 32'd1;
    if (done_valid_o && done_ready_i) done_q <= 1'b1;
    valid_q <= {valid_q[LATENCY-2:0], issue};
    word_q <= {word_q[20*(LATENCY-1)-1:0], next_q};
    case (counter_addr_i)
      8'd0: counter_data_o <= written_q;
      8'd1: counter_data_o <= tokens_q;
      default: counter_data_o <= 32'd0;
    endcase
    if (counter_clear_i) written_q <= 32'd0;
    if (!rst_ni) begin
      tokens_q <= 32'd0;
      next_q <= 20'd0;
      done_q <= 1'b0;
      pace_q <= 1'b0;
      valid_q <= {LATENCY{1'b0}};
    end
  end

`ifdef HLS_ASSERT
  always @(posedge clk_i) begin
    if (rst_ni && fed && background == 32'h00badbad) begin
      $display("%m: a violation was asked for");
      $stop;
    end
  end
`endif

endmodule
